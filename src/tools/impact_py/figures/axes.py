"""What figures of the restitution have in common."""


from ..style import marker_style, ticks


def draw_restitution(ax, curve, value, colour, marker, filled=True):
    """`value` of the mean restitution against speed as markers; its standard error as a band."""
    v, e, error = curve["velocity"], curve["restitution"], curve["restitution_error"]
    ax.fill_between(v, value(e - error), value(e + error), color=colour, alpha=0.3, linewidth=0)
    ax.plot(v, value(e), **marker_style(colour, marker, filled))


def speed_axis(ax, values=(0.003, 0.005, 0.01, 0.02, 0.05)):
    """A logarithmic axis of the impact speed with these ticks."""
    ax.set_xscale("log")
    ax.set_xlim(0.0026, 0.058)
    ticks(ax.xaxis, values)


def sound_speed_axis(ax, table):
    """The same axis in units of the speed of sound, above."""
    row = table.first_row()
    ratio = row["velocity_by_sound_speed"] / row["velocity"]
    ax.tick_params(axis="x", which="both", top=False)
    top = ax.secondary_xaxis("top", functions=(lambda v: v * ratio, lambda v: v / ratio))
    ticks(top.xaxis, [0.002, 0.005, 0.01, 0.02])
    top.set_xlabel("$v/c_s$")

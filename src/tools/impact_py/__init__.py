"""What plot_impact, plot_sweep, plot_figures and convert are made of."""

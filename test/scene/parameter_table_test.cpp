#include "scene/parameter_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <regex>

#include "expect_input_error.hpp"

namespace impact {
namespace {

enum class Colour { kRed, kGreen };

struct Thing {
  double size = 0.5;
  std::optional<double> weight;
  int count = 3;
  bool round = true;
  Colour colour = Colour::kRed;
  std::string label;
  std::vector<std::string> names;
};

const std::vector<Parameter<Thing>>& table() {
  static const std::vector<Parameter<Thing>> parameters{
      real<Thing>(
          "size", "m", {0.0, 1.0, false}, "how large", [](Thing & t) -> auto& { return t.size; }),
      real_or_auto<Thing>(
          "body.weight", "kg", {0.0, 10.0}, "how heavy",
          [](Thing & t) -> auto& { return t.weight; }),
      whole<Thing>(
          "count", 1, 9, "how many", [](Thing & t) -> auto& { return t.count; }),
      flag<Thing>(
          "round", "whether round", [](Thing & t) -> auto& { return t.round; }),
      choice<Thing, Colour>(
          "colour", {{"red", Colour::kRed}, {"green", Colour::kGreen}}, "which colour",
          [](Thing & t) -> auto& { return t.colour; }),
      text<Thing>(
          "label", "what it is called", [](Thing & t) -> auto& { return t.label; }),
      texts<Thing>(
          "names", "of its friends", [](Thing & t) -> auto& { return t.names; })};
  return parameters;
}

Thing read(const std::string& yaml) {
  Thing thing;
  read_parameters(table(), flatten(YAML::Load(yaml)), thing);
  return thing;
}

TEST(ReadParameters, SetsWhatIsNamedAndKeepsTheRest) {
  const Thing thing = read(
      "{size: 0.25, body: {weight: 2}, count: 7, round: false, colour: green, label: x, "
      "names: [a, b]}");
  EXPECT_EQ(thing.size, 0.25);
  EXPECT_EQ(thing.weight, 2.0);
  EXPECT_EQ(thing.count, 7);
  EXPECT_FALSE(thing.round);
  EXPECT_EQ(thing.colour, Colour::kGreen);
  EXPECT_EQ(thing.label, "x");
  EXPECT_EQ(thing.names, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(read("{count: 7}").size, 0.5);
  EXPECT_FALSE(read("{body: {weight: auto}}").weight.has_value());
}

TEST(ReadParameters, NamesKeyValueAndWhatIsAllowed) {
  EXPECT_INPUT_ERROR(read("{size: fast}"), "size: got fast, allowed: number in (0, 1]");
  EXPECT_INPUT_ERROR(read("{size: 0}"), "size: got 0, allowed: number in (0, 1]");
  EXPECT_INPUT_ERROR(read("{size: 1.5}"), "size: got 1.5, allowed");
  EXPECT_INPUT_ERROR(read("{size: .nan}"), "size: got .nan, allowed");
  EXPECT_INPUT_ERROR(read("{size: .inf}"), "size: got .inf, allowed");
  EXPECT_INPUT_ERROR(read("{size: true}"), "size: got true, allowed");
  EXPECT_INPUT_ERROR(read("{size: [0.1, 0.2]}"), "size: got [0.1, 0.2], allowed");
  EXPECT_INPUT_ERROR(read("{size: }"), "size: got nothing, allowed");
  EXPECT_INPUT_ERROR(read("{size: '0.1'}"), "size: got \"0.1\", allowed");
  EXPECT_INPUT_ERROR(read("{size: {x: 1}}"), "size.x: unknown key");
  EXPECT_INPUT_ERROR(read("{size: [[1], {x: 1}]}"), "size: got [a list, a map], allowed");
  EXPECT_INPUT_ERROR(read("{size: 0.1, size: 0.2}"), "size: given twice");
  EXPECT_INPUT_ERROR(read("{body: &b {weight: *b}}"), "nested too deeply");
  EXPECT_INPUT_ERROR(read("{size: &s [*s]}"), "size: got [a list], allowed");
  EXPECT_INPUT_ERROR(read("{count: '3'}"), "count: got \"3\", allowed");
  EXPECT_INPUT_ERROR(read("{count: 03x}"), "count: got 03x, allowed");
  EXPECT_INPUT_ERROR(read("{round: 'true'}"), "round: got \"true\", allowed");
  EXPECT_INPUT_ERROR(read("{count: 03}"), "count: got 03, allowed");
  EXPECT_INPUT_ERROR(read("{size: 00.5}"), "size: got 00.5, allowed");
  EXPECT_INPUT_ERROR(read("{body: {weight: often}}"),
                     "body.weight: got often, allowed: auto or number in [0, 10]");
  EXPECT_INPUT_ERROR(read("{count: 2.5}"), "count: got 2.5, allowed: whole number in [1, 9]");
  EXPECT_INPUT_ERROR(read("{count: 10}"), "count: got 10");
  EXPECT_INPUT_ERROR(read("{round: 2}"), "round: got 2, allowed: true or false");
  EXPECT_INPUT_ERROR(read("{colour: blue}"), "colour: got blue, allowed: red or green");
  EXPECT_INPUT_ERROR(read("{names: a}"), "names: got a, allowed: list of texts");
  EXPECT_INPUT_ERROR(read("{sise: 1}"),
                     "sise: unknown key (did you mean size?), allowed: size, body.weight, count");
  EXPECT_INPUT_ERROR(read("{body: 3}"), "body: unknown key");
  EXPECT_INPUT_ERROR(read("[1, 2]"), "got [1, 2], allowed: a map");
}

TEST(ReadParameters, WhatDoesNotApplyIsUnknown) {
  std::vector<Parameter<Thing>> parameters = table();
  parameters[0].applies = [](const Thing& thing) { return thing.count == 1; };
  Thing thing;
  const FlatTree keys = flatten(YAML::Load("{size: 0.1}"));
  EXPECT_INPUT_ERROR(read_parameters(parameters, keys, thing), "size: unknown key, allowed: body");
}

TEST(WriteParameters, ReadsBackToTheSameBits) {
  Thing thing;
  thing.size = 0.1 + 0.2;
  thing.weight = 1.0 / 3.0;
  thing.colour = Colour::kGreen;
  thing.names = {"a"};
  const Thing again = read(YAML::Dump(write_parameters(table(), thing)));
  EXPECT_EQ(again.size, thing.size);
  EXPECT_EQ(again.weight, thing.weight);
  EXPECT_EQ(again.colour, thing.colour);
  EXPECT_EQ(again.names, thing.names);
}

TEST(ReadParameters, ShowsWhatItGotOnOneShortLine) {
  EXPECT_INPUT_ERROR(read("{count: \"\\e[31m\"}"), "count: got \"\\x1b[31m\", allowed");
  EXPECT_INPUT_ERROR(read("{\"co\\aunt\": 1}"), "co\\x07unt: unknown key");
  try {
    read("{count: " + std::string(5000, 'x') + "}");
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_LT(std::string(error.what()).size(), 200U);
    EXPECT_NE(std::string(error.what()).find("(5000 bytes)"), std::string::npos);
  }
}

TEST(Shown, CutsBetweenCharacters) {
  std::string text;
  while (text.size() < 300) text += "η";  // two bytes each
  EXPECT_EQ(shown("x" + text).substr(0, 105), "x" + text.substr(0, 98) + "… (3");
}

/// What PyYAML, which follows YAML 1.1, takes for a real number.
TEST(Exact, IsANumberForYaml11AndYaml12) {
  const std::regex number(R"([-+]?[0-9]+\.[0-9]*([eE][-+][0-9]+)?|[-+]?[0-9]+|[-+]?\.inf|\.nan)");
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double value : {1e-5, -1e-5, 1.5e-300, 1e16, 1e300, 0.1, 3.0, -0.0, 5e-324, kInfinity,
                             -kInfinity, std::nan(""), -std::nan("")}) {
    const std::string text = exact(value).Scalar();
    EXPECT_TRUE(std::regex_match(text, number)) << text;
    const auto again = YAML::Load(text).as<double>();
    EXPECT_TRUE(again == value || (std::isnan(again) && std::isnan(value))) << text;
  }
}

TEST(CellText, IsAsInC) {
  EXPECT_EQ(cell_text(exact(1e-5)), "1e-05");
  EXPECT_EQ(cell_text(exact(0.1)), "0.1");
  EXPECT_EQ(cell_text(exact(-std::nan(""))), "nan");
  EXPECT_EQ(cell_text(exact(-std::numeric_limits<double>::infinity())), "-inf");
  EXPECT_EQ(cell_text(YAML::Node("a.data")), "a.data");
  EXPECT_EQ(cell_text(YAML::Node(9007199254740993)), "9007199254740993");
}

TEST(MarkdownTable, HasARowAParameter) {
  const std::string rows = markdown_table(table(), Thing{});
  EXPECT_NE(rows.find("| `size` | `0.5` | number in (0, 1] m | how large |\n"), std::string::npos)
      << rows;
}

TEST(ParameterList, HasValueUnitAndWhatIsAllowed) {
  const std::string rows = parameter_list(table(), Thing{});
  EXPECT_NE(rows.find("  size = 0.5 m  (number in (0, 1])\n      how large\n"), std::string::npos)
      << rows;
}

}  // namespace
}  // namespace impact

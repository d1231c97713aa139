#include "Base/json/checked_json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "Base/error.h"

namespace base {
namespace {

using nlohmann::json;

template <class Ask>
std::string refusal(Ask&& ask) {
  try {
    ask();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(CheckedJson, GivesWhatIsAskedFor) {
  const json document = {
      {"a", {{"x", 0.5}, {"n", 7}}}, {"list", {1, 2.5}}, {"text", "b"}, {"raw", json::binary({1, 2})}};
  const CheckedJson value(document, "");
  EXPECT_EQ(value.at("a").at("x").positive_number(), 0.5);
  EXPECT_EQ(value.at("a").at("n").whole_number(), 7);
  EXPECT_EQ(value.at("a").at("n").index(), 7U);
  EXPECT_EQ(value.at("list").finite_numbers(2), (std::vector{1.0, 2.5}));
  EXPECT_EQ(value.at("list").entries().size(), 2U);
  EXPECT_EQ(value.at("text").text(), "b");
  EXPECT_EQ(value.at("raw").bytes(), (std::vector<std::uint8_t>{1, 2}));
  EXPECT_TRUE(value.has("a"));
  EXPECT_FALSE(value.has("b"));
  EXPECT_FALSE(value.at("text").has("b"));
}

TEST(CheckedJson, SaysByNameWhatIsWrong) {
  const json document = {{"a", {{"x", std::nan("")}, {"n", -1}}}, {"list", {1, "b"}}, {"large", ~std::uint64_t{0}}};
  const CheckedJson value(document, "state");
  EXPECT_EQ(refusal([&] { (void)value.at("b"); }), "state has no 'b'");
  EXPECT_EQ(refusal([&] { (void)value.at("list").at("b"); }), "state.list has no 'b'");
  EXPECT_EQ(refusal([&] { (void)value.at("a").at("x").finite_number(); }), "state.a.x is not finite");
  EXPECT_EQ(refusal([&] { (void)value.at("a").at("n").positive_number(); }), "state.a.n is not > 0");
  EXPECT_EQ(refusal([&] { (void)value.at("a").at("n").whole_number(0, 9); }), "state.a.n is not from 0 to 9");
  EXPECT_EQ(refusal([&] { (void)value.at("large").whole_number(0, 9); }), "state.large is not from 0 to 9");
  EXPECT_NE(refusal([&] { (void)value.at("large").index(); }), "");
  EXPECT_EQ(refusal([&] { (void)value.at("a").at("x").whole_number(); }), "state.a.x is not a whole number");
  EXPECT_EQ(refusal([&] { (void)value.at("list").finite_numbers(2); }), "state.list is not a number");
  EXPECT_EQ(refusal([&] { (void)value.at("list").finite_numbers(3); }), "state.list is not a list of 3");
  EXPECT_EQ(refusal([&] { (void)value.at("a").entries(); }), "state.a is not a list");
  EXPECT_EQ(refusal([&] { (void)value.at("list").text(); }), "state.list is not a text");
  EXPECT_EQ(refusal([&] { (void)value.at("list").bytes(); }), "state.list is not binary data");
  EXPECT_EQ(refusal([&] { (void)CheckedJson(document, "").at("b"); }), "it has no 'b'");
}

}  // namespace
}  // namespace base

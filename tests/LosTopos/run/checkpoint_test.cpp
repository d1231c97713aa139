#include "LosTopos/run/checkpoint.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "Base/error.h"
#include "LosTopos/run/cbor_form.h"
#include "LosTopos/run/sealed_bytes.h"
#include "tests/LosTopos/run/fake_motion.h"
#include "tests/support/scratch_folder.h"

namespace lostopos::run {
namespace {

using nlohmann::json;
using ::test::ScratchFolder;
using Bytes = std::vector<std::uint8_t>;

const CheckpointFormat fake{"fake", 1};

// The message of the InputError that reading these bytes ends in; empty: they are taken.
std::string refusal(
    std::span<const std::uint8_t> bytes, const TakeCheckpoint& take = [](const json&) {}) {
  try {
    take_checkpoint(bytes, "x.cbor", fake, take);
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "";
}

void expect_refusal(const std::string& part, const Bytes& bytes) {
  const std::string message = refusal(bytes);
  EXPECT_TRUE(message.starts_with("x.cbor is not a whole checkpoint: ")) << message;
  EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' is not in '" << message << "'";
}

Bytes small_checkpoint() {
  return checkpoint_bytes(fake, {{"steps", 3}, {"x", 0.1}, {"raw", json::binary({1, 2, 3, 4})}});
}

TEST(Checkpoint, IsReadAsItWasWritten) {
  const ScratchFolder scratch;
  const json content = {{"steps", 3}, {"x", 0.1}, {"raw", json::binary({1, 2})}, {"list", {1, "b", nullptr, true}}};
  write_checkpoint(scratch.path() / "checkpoint.cbor", fake, content);
  json read;
  read_checkpoint(scratch.path() / "checkpoint.cbor", fake, [&](const json& taken) { read = taken; });
  read.erase("format");
  read.erase("version");
  EXPECT_EQ(read, content);
}

TEST(Checkpoint, WithAnyBitTurnedOverIsRefused) {
  const Bytes whole = small_checkpoint();
  ASSERT_EQ(refusal(whole), "");
  for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
    Bytes damaged = whole;
    damaged[bit / 8] = static_cast<std::uint8_t>(damaged[bit / 8] ^ (1U << (bit % 8)));
    EXPECT_NE(refusal(damaged), "") << "bit " << bit;
  }
}

TEST(Checkpoint, CutShortAtEveryByteOrLengthenedIsRefused) {
  Bytes whole = small_checkpoint();
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_NE(refusal(std::span(whole).first(size)), "") << size << " bytes";
  whole.push_back(0);
  expect_refusal("cut off or damaged", whole);
}

TEST(Checkpoint, OfBeforeThereWereChecksumsIsRefusedByItsVersion) {
  expect_refusal("it is a foamsim checkpoint of version 4, from before they had checksums",
                 json::to_cbor({{"format", "foamsim checkpoint"}, {"version", 4}, {"state", json::object()}}));
  expect_refusal("does not begin as one", json::to_cbor({{"format", "else"}, {"version", 4}}));
}

TEST(Checkpoint, OfAnotherProgramOrVersionIsRefusedByName) {
  expect_refusal("it is a fake checkpoint of version 2, where a fake checkpoint of version 1 belongs",
                 checkpoint_bytes({"fake", 2}, {{"steps", 1}}));
  expect_refusal("it is a other checkpoint of version 1", checkpoint_bytes({"other", 1}, {{"steps", 1}}));
  expect_refusal("it is none", sealed(json::to_cbor({{"steps", 1}})));
  expect_refusal("it is none", sealed(json::to_cbor({{"format", 3}, {"version", 1}})));
  expect_refusal("does not begin as one", {'n', 'o'});
  expect_refusal("does not begin as one", {});
  Bytes later = small_checkpoint();
  later[8] = 9;
  expect_refusal("its form is of version 9", later);
}

TEST(Checkpoint, IsNamedByItsFile) {
  const ScratchFolder scratch;
  const auto file = scratch.path() / "checkpoint.cbor";
  EXPECT_THROW(test::FakeMotion::resumed(file), base::FileError);
  std::ofstream(file) << "no checkpoint";
  try {
    test::FakeMotion::resumed(file);
    FAIL();
  } catch (const base::InputError& error) {
    EXPECT_NE(std::string(error.what()).find(file.string()), std::string::npos);
  }
  write_checkpoint(file, fake, {{"stops", 1}});
  EXPECT_THROW(test::FakeMotion::resumed(file), base::InputError);
}

// Content whose checksum is right may be anything.
TEST(Checkpoint, WhateverItsContentMakesOfItIsAnInputErrorOfOneLine) {
  const Bytes whole = small_checkpoint();
  const auto thrown = [&](const std::function<void()>& what) { return refusal(whole, [&](const json&) { what(); }); };
  const std::string begin = "x.cbor is not a whole checkpoint: ";
  EXPECT_EQ(thrown([] { throw std::out_of_range("array::at"); }), begin + "array::at");
  EXPECT_EQ(thrown([] { throw MeshError("broken\nin\x1btwo"); }), begin + "broken in two");
  EXPECT_TRUE(thrown([] { (void)json(3).at("x"); }).starts_with(begin));
  EXPECT_THROW(thrown([] { throw std::bad_alloc(); }), std::bad_alloc);
}

TEST(Checkpoint, OfFormsThatItIsNeverWrittenInIsRefused) {
  const auto is_plain = [](const Bytes& bytes) { return is_plain_cbor(bytes); };
  EXPECT_TRUE(is_plain(json::to_cbor({{"a", {1, -1, 2.5, 1e300, "b", nullptr, true, ~std::uint64_t{0}}}})));
  EXPECT_TRUE(is_plain(json::to_cbor(json::binary(Bytes(70000)))));
  EXPECT_FALSE(is_plain({}));
  EXPECT_FALSE(is_plain({0x01, 0x01})) << "two values";
  EXPECT_FALSE(is_plain({0x9f, 0x01, 0xff})) << "a list without a length";
  EXPECT_FALSE(is_plain({0x7f, 0x61, 'a', 0xff})) << "a text in pieces";
  EXPECT_FALSE(is_plain({0xc1, 0x01})) << "a tag";
  EXPECT_FALSE(is_plain({0x1c})) << "reserved";
  EXPECT_FALSE(is_plain({0x9b, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff})) << "longer than the bytes";
  EXPECT_FALSE(is_plain({0x5a, 0x00, 0x00, 0x01, 0x00, 0x01})) << "data that is cut off";
}

// A reader that calls itself for each of them runs out of stack.
TEST(Checkpoint, OfListsWithinListsOrTextsInPiecesIsRefused) {
  for (std::uint8_t opening : {0x81, 0x9f, 0x7f, 0x5f, 0xbf, 0xc6}) {
    expect_refusal("it is none", sealed(Bytes(10'000'000, opening)));
    expect_refusal("does not begin as one", Bytes(10'000'000, opening));
  }
}

}  // namespace
}  // namespace lostopos::run

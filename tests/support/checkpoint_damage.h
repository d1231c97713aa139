#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "LosTopos/run/checkpoint.h"
#include "LosTopos/run/motion.h"

namespace test {

/// Checkpoints that somebody has changed, and what becomes of them.
class DamagedCheckpoints {
 public:
  /// Makes the motion that goes on from the content of a checkpoint.
  using Resume = std::function<std::unique_ptr<lostopos::run::Motion>(const nlohmann::json& content)>;

  /// `motion`: what is to be damaged, a few steps after its start.
  DamagedCheckpoints(const lostopos::run::Motion& motion, lostopos::run::CheckpointFormat format, Resume resume);

  /// Turns bits at `count` places over, at random, and expects that each file is refused.
  void expect_flips_refused(int count, std::uint64_t seed) const;
  /// The same with the checksum made right again: each is refused, or goes on from a surface with sound links, and
  /// makes a step or says why it cannot.
  void expect_hidden_flips_survived(int count, std::uint64_t seed) const;
  /// Puts values that do not belong there in the place of every value of the document, a few of every list, checksums
  /// right: with the same outcome, but that no step is made with other options, which anybody may give.
  void expect_replacements_survived() const;

 private:
  using Bytes = std::vector<std::uint8_t>;
  enum class Then { step, end };
  // Whether it is refused; a test failure for what is neither that nor a motion that can be trusted.
  bool refused(const Bytes& bytes, const std::string& what, Then then = Then::step) const;
  void expect_survived(const Bytes& bytes, const std::string& what, Then then) const;

  lostopos::run::CheckpointFormat format_;
  Resume resume_;
  nlohmann::json content_;
};

}  // namespace test

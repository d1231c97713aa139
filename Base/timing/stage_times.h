#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace base {

/// Wall seconds spent in named stages, in the order in which the stages first ran.
class StageTimes {
 public:
  void add(std::string_view stage, double seconds);
  void add(const StageTimes& other);
  double seconds(std::string_view stage) const;
  double total() const;
  const std::vector<std::pair<std::string, double>>& stages() const { return stages_; }

 private:
  std::vector<std::pair<std::string, double>> stages_;
};

}  // namespace base

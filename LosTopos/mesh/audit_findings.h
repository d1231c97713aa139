#pragma once

#include <sstream>

#include "LosTopos/mesh/audit.h"

namespace lostopos {

/// Where the parts of an audit put what they find.
class AuditFindings {
 public:
  AuditFindings(AuditReport& report, std::size_t most) : report_(report), most_(most) {}

  bool full() const { return report_.findings.size() >= most_; }
  template <class... Parts>
  void add(Defect defect, const Parts&... parts) {
    if (full()) {
      report_.truncated = true;
      return;
    }
    std::ostringstream message;
    message.precision(17);
    (message << ... << parts);
    report_.findings.push_back({defect, message.str()});
  }

 private:
  AuditReport& report_;
  std::size_t most_;
};

/// "vertex 5 at (0 0 1)".
std::string described(const SurfaceMesh& mesh, Vertex v);

}  // namespace lostopos

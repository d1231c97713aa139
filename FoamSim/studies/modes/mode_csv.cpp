#include "FoamSim/studies/modes/mode_csv.h"

#include <initializer_list>
#include <string>

#include "Base/io/atomic_file.h"
#include "Base/io/number_text.h"

namespace foamsim {
namespace {

void write_file(const std::filesystem::path& path, const std::string& text) {
  base::AtomicFile file(path);
  file.stream() << text;
  file.commit();
}

// "mode,triangles,number,number,…" and the end of the line.
void append_row(std::string& text, long mode, std::size_t triangles, std::initializer_list<double> numbers,
                const char* end = "\n") {
  text += std::to_string(mode) + "," + std::to_string(triangles);
  for (double number : numbers) {
    text += ',';
    base::append_number(text, number);
  }
  text += end;
}

void append_run(std::string& text, const ModeRun& run, const double* order) {
  append_row(text, run.options.mode, run.triangles,
             {run.resolution, run.delta, run.options.dt, run.omega, run.omega_theory, run.frequency_error(),
              run.period_error()},
             ",");
  if (order != nullptr) base::append_number(text, *order);
  for (double number : {run.energy_drift, run.peak_impulse / run.peak_impulse_scale}) {
    text += ',';
    base::append_number(text, number);
  }
  text += '\n';
}

}  // namespace

void write_mode_csv(const std::filesystem::path& file, const std::vector<ModeConvergence>& results) {
  std::string text = "mode,triangles,time,measured,theory\n";
  for (const ModeConvergence& result : results)
    for (const ModeRun& run : result.runs)
      for (const ModeSample& s : run.samples)
        append_row(text, run.options.mode, run.triangles, {s.time, s.measured, s.theory});
  write_file(file, text);
}

void write_mode_summary_csv(const std::filesystem::path& file, const std::vector<ModeConvergence>& results) {
  std::string text =
      "mode,triangles,resolution,delta,dt,omega,omega_theory,frequency_error,period_error,order,energy_drift,"
      "impulse_ratio\n";
  for (const ModeConvergence& result : results) {
    for (std::size_t i = 0; i < result.runs.size(); ++i)
      append_run(text, result.runs[i], i == 0 ? nullptr : &result.observed_orders[i - 1]);
    const ModeRun& finest = result.runs.back();
    text += std::to_string(finest.options.mode) + ",0,0,0,,";
    base::append_number(text, result.extrapolated_omega);
    text += ',';
    base::append_number(text, finest.omega_theory);
    text += ',';
    base::append_number(text, result.extrapolated_error());
    text += ',';
    base::append_number(text, finest.omega_theory / result.extrapolated_omega - 1);
    text += ",,,\n";
  }
  write_file(file, text);
}

}  // namespace foamsim

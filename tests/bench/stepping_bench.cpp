// SPDX-License-Identifier: MIT
// bench_stepping DESCRIPTION [stepped | constant]: processor time of a tick of the run that a JSON description names, without
// files: by run_until, or stepped from outside by the outputs of its own brains or by 1. For stepping.py, which compares Python.
#include <cstdio>
#include <ctime>
#include <string_view>
#include <tools/tables/shipped_tables.hpp>
#include <trophic/experiment/stepped_ecology.hpp>
#include <vector>

namespace {

double processor_s() {
  ::timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

int main(int argc, char** argv) {
  const trophic::Offer offer{.rule_tables = trophic::command::shipped_tables()};
  const trophic::Json description = trophic::Json::parse(argv[1]);
  double began_s = 0.0;
  std::int64_t ticks = 0;
  if (argc > 2) {
    trophic::SteppedEcology ecology{description, offer};
    ecology.reset();
    began_s = processor_s();
    if (std::string_view{argv[2]} == "constant") {
      std::vector<double> outputs;
      while (ecology.sense()) {
        outputs.assign(ecology.perceived().bodies.size() * ecology.perceived().outputs_each, 1.0);
        ecology.decide(outputs);
      }
    } else {
      static_cast<void>(ecology.run_until(ecology.until_s()));
    }
    ticks = ecology.simulation().tick();
  } else {
    const auto run = trophic::described_run(description, offer);
    const auto simulation = run.simulation();
    began_s = processor_s();
    simulation->run_until(run.experiment->ecology().duration_s);
    ticks = simulation->tick();
  }
  std::printf("%.9g\n", (processor_s() - began_s) / static_cast<double>(ticks));
}

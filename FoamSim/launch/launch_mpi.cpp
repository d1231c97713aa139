#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include "FoamSim/launch/launch.h"

namespace foamsim {

namespace {

// Messages count elements by an int.
constexpr std::size_t most_elements = std::size_t{1} << 28U;

template <class Send>
void in_pieces(std::span<double> values, const Send& send) {
  for (std::size_t first = 0; first < values.size(); first += most_elements)
    send(values.data() + first, static_cast<int>(std::min(most_elements, values.size() - first)));
}

class MpiRanks final : public base::Ranks {
 public:
  MpiRanks() {
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  }
  std::size_t size() const override { return static_cast<std::size_t>(size_); }
  std::size_t rank() const override { return static_cast<std::size_t>(rank_); }

  // By bits, so that a zero keeps its sign.
  void gather(std::span<double> values) const override {
    static_assert(sizeof(double) == sizeof(std::uint64_t));
    in_pieces(values, [](double* data, int count) {
      MPI_Allreduce(MPI_IN_PLACE, data, count, MPI_UINT64_T, MPI_BOR, MPI_COMM_WORLD);
    });
  }

  void in_turn(std::span<double> values, const std::function<void()>& add) const override {
    if (rank_ > 0)
      in_pieces(values, [this](double* data, int count) {
        MPI_Recv(data, count, MPI_DOUBLE, rank_ - 1, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
      });
    add();
    if (rank_ + 1 < size_)
      in_pieces(values,
                [this](double* data, int count) { MPI_Send(data, count, MPI_DOUBLE, rank_ + 1, 0, MPI_COMM_WORLD); });
    in_pieces(values,
              [this](double* data, int count) { MPI_Bcast(data, count, MPI_DOUBLE, size_ - 1, MPI_COMM_WORLD); });
  }

  bool any(bool here) const override {
    int value = here ? 1 : 0;
    MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
    return value != 0;
  }

 private:
  int size_ = 1, rank_ = 0;
};

// The first rank speaks for all.
class MpiLaunch final : public Launch {
 public:
  MpiLaunch(int& argc, char**& argv) {
    int provided = 0;
    MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
    ranks_ = std::make_shared<const MpiRanks>();
    if (ranks_->rank() == 0) return;
    for (std::FILE* stream : {stdout, stderr})
      if (std::freopen("/dev/null", "w", stream) == nullptr) MPI_Abort(MPI_COMM_WORLD, EXIT_FAILURE);
  }
  ~MpiLaunch() override = default;
  std::shared_ptr<const base::Ranks> ranks() const override { return ranks_; }

  int end(int exit_code) override {
    std::fflush(stdout);
    // An interruption is everybody's; after a failure others may wait for this rank for ever. What all have come to,
    // the first has to save and say before it is ended.
    constexpr int signalled = 128;
    constexpr auto enough_to_save = std::chrono::seconds(60);
    if (exit_code != 0 && exit_code < signalled) {
      if (ranks_->rank() > 0) std::this_thread::sleep_for(enough_to_save);
      MPI_Abort(MPI_COMM_WORLD, exit_code);
    }
    MPI_Finalize();
    return exit_code;
  }

 private:
  std::shared_ptr<const base::Ranks> ranks_;
};

class OneProcess final : public Launch {
 public:
  std::shared_ptr<const base::Ranks> ranks() const override { return base::alone(); }
  int end(int exit_code) override { return exit_code; }
};

}  // namespace

// Without a launcher MPI is left alone: it would start helpers of its own.
std::unique_ptr<Launch> launch(int& argc, char**& argv) {
  const bool launched = std::ranges::any_of(std::initializer_list<const char*>{"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"},
                                            [](const char* name) { return std::getenv(name) != nullptr; });
  if (!launched) return std::make_unique<OneProcess>();
  return std::make_unique<MpiLaunch>(argc, argv);
}

}  // namespace foamsim

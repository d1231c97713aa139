// Writes small files for every harness to begin with: make_fuzz_corpus FOLDER.
#include <cstdio>

#include "Base/error.h"
#include "tests/fuzz/corpus.h"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  try {
    fuzz::write_corpus(argv[1]);
  } catch (const base::Error& error) {
    std::fprintf(stderr, "make_fuzz_corpus: %s\n", error.what());
    return 2;
  }
  return 0;
}

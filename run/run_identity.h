// What a run is: the values of its entries, the bytes of every file they name, and the program. Two runs of
// the same identity give the same numbers. Checkpoints, studies, validations and scripts all go by it.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace turgor {
struct RunIdentity {
  /// A file that an entry names.
  struct NamedFile {
    std::string entry, name, bytes;  ///< Section/Name; its name in the output directory's folder input_files
  };
  using Entries =
      std::vector<std::pair<std::string, std::string>>;  ///< Section/Name and value, numbers in one spelling

  Entries deciding;  ///< what the state depends on; for a file, its checksum
  Entries ends;      ///< how far the run goes
  Entries free;      ///< what is written and how often
  std::vector<NamedFile> files;
  std::string program;  ///< checksum of the executable

  /// Of everything, 16 hexadecimal digits: the same question to the same program.
  std::string hash() const;
  /// Of all entries and files, whatever the program.
  std::string input_hash() const;
  /// Of what the state depends on and the program, wherever the run ends: a checkpoint of the same goes on to
  /// the same bits.
  std::string state_hash() const;
};

/// "'Contact/Adhesion' was 1e-4 and is 2e-4" for the first entry that differs; empty if none does.
std::string difference(const RunIdentity::Entries &before, const RunIdentity::Entries &now);
}  // namespace turgor

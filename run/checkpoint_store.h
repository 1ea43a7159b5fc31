// Checkpoints of one run: DIR/checkpoint.0 and DIR/checkpoint.1, written in turn, so that
// the older generation is untouched while the newer is written.
//
// File: magic (8 bytes), format (u32), CRC-32 of the body (u32), length of the body (u64),
// body = length of the record (u64), record (JSON: generation, program, the entries that decide or end the
// run, and what the caller adds), payload. Little endian, as on every machine we build for.
#pragma once

#include "run/run_identity.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace turgor {
struct Checkpoint {
  std::uint64_t generation = 0;  ///< counts from 1
  std::string record;            ///< JSON text given to write()
  std::string payload;
};

class CheckpointStore {
 public:
  CheckpointStore(std::filesystem::path directory, RunIdentity identity);

  /// Atomic; replaces the older of the two generations. record is a JSON object.
  void write(const nlohmann::json &record, std::string_view payload);

  /// The newest undamaged generation, or nothing when there is no checkpoint file.
  /// Throws InputError when all are damaged, or when it belongs to another program or input (which may end
  /// later, though); or_none: nothing then. `damage` gets a sentence for each file that was passed over.
  std::optional<Checkpoint> read_newest(bool or_none, std::string *damage = nullptr);

  bool exists() const;  ///< any generation, damaged or not

  static constexpr std::uint32_t format = 3;
  static constexpr const char *file_names[2] = {"checkpoint.0", "checkpoint.1"};

 private:
  std::filesystem::path directory;
  RunIdentity identity;
  std::uint64_t last_generation = 0;
};
}  // namespace turgor

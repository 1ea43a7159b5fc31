#include "run/checkpoint_store.h"

#include "run/atomic_file.h"
#include "run/checksum.h"
#include "run/number_text.h"
#include "run/run_context.h"

#include <nlohmann/json.hpp>

#include <cstdlib>
#include <cstring>

namespace turgor {
namespace {
constexpr char magic[] = "TURGORcp";  // 8 bytes without the end
constexpr std::size_t head_length = 8 + 4 + 4 + 8;

template <typename Number>
void append(std::string &bytes, const Number number) {
  bytes.append(reinterpret_cast<const char *>(&number), sizeof(number));
}

template <typename Number>
Number take(const std::string_view bytes, const std::size_t where) {
  Number number;
  std::memcpy(&number, bytes.data() + where, sizeof(number));
  return number;
}

struct Parsed {
  nlohmann::json record;
  std::string payload;
};

/// Throws std::runtime_error with what is wrong.
Parsed parse(const std::string &bytes) {
  if (bytes.size() < head_length || bytes.compare(0, 8, magic, 8) != 0)
    throw std::runtime_error("it is not a checkpoint of turgor");
  const auto format = take<std::uint32_t>(bytes, 8);
  if (format != CheckpointStore::format)
    throw std::runtime_error("its format is " + number_text(format) + ", this program reads " +
                             number_text(CheckpointStore::format));
  const auto crc = take<std::uint32_t>(bytes, 12);
  const auto length = take<std::uint64_t>(bytes, 16);
  if (bytes.size() - head_length != length || length < 8) throw std::runtime_error("it is cut short");
  const std::string_view body(bytes.data() + head_length, length);
  if (crc32(body) != crc) throw std::runtime_error("its checksum is wrong");
  const auto record_length = take<std::uint64_t>(body, 0);
  if (record_length > length - 8) throw std::runtime_error("its record is cut short");
  return {nlohmann::json::parse(body.substr(8, record_length)), std::string(body.substr(8 + record_length))};
}
/// Empty when a run of this identity can go on from a checkpoint with this record.
std::string why_foreign(const nlohmann::json &record, const RunIdentity &identity) {
  const auto entries = [&](const char *name) { return record.value(name, RunIdentity::Entries()); };
  if (const std::string other = difference(entries("deciding"), identity.deciding); !other.empty())
    return "belongs to another input: " + other +
           ". Resume with the same input and --set values, choose another output directory with -o, "
           "or run without --resume to start again.";
  if (record.value("program", "") != identity.program)
    return "was written by another build of this program: the numbers would not go on as they began. Resume "
           "with that build, or run "
           "without --resume to start again.";
  const RunIdentity::Entries before = entries("ends");
  for (std::size_t k = 0; k < before.size() && k < identity.ends.size(); ++k)
    if (std::strtod(identity.ends[k].second.c_str(), nullptr) <
        std::strtod(before[k].second.c_str(), nullptr))
      return "belongs to a run that goes further: " + difference({before[k]}, {identity.ends[k]}) +
             ". A resumed run can end later, not earlier.";
  return "";
}
}  // namespace

CheckpointStore::CheckpointStore(std::filesystem::path directory_, RunIdentity identity_)
    : directory(std::move(directory_)), identity(std::move(identity_)) {}

void CheckpointStore::write(const nlohmann::json &record, const std::string_view payload) {
  const std::uint64_t generation = last_generation + 1;
  const nlohmann::json full = {{"generation", generation},
                               {"program", identity.program},
                               {"deciding", identity.deciding},
                               {"ends", identity.ends},
                               {"record", record}};
  const std::string text =
      full.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);  // a file's name may be any bytes
  std::string body;
  body.reserve(8 + text.size() + payload.size());
  append<std::uint64_t>(body, text.size());
  body += text;
  body += payload;
  std::string bytes(magic, 8);
  append(bytes, format);
  append(bytes, crc32(body));
  append<std::uint64_t>(bytes, body.size());
  bytes += body;
  write_atomically(directory / file_names[generation % 2], bytes);
  last_generation = generation;
}

bool CheckpointStore::exists() const {
  return std::filesystem::exists(directory / file_names[0]) ||
         std::filesystem::exists(directory / file_names[1]);
}

std::optional<Checkpoint> CheckpointStore::read_newest(const bool or_none, std::string *damage) {
  std::optional<Checkpoint> newest;
  std::string sentences, foreign;
  for (const char *file_name : file_names) {
    const std::filesystem::path path = directory / file_name;
    if (!std::filesystem::exists(path)) continue;
    Parsed parsed;
    try {
      parsed = parse(read_whole(path));
    } catch (const std::exception &problem) {
      sentences += (sentences.empty() ? "" : " ") + path.string() + " is damaged: " + problem.what() + ".";
      continue;
    }
    if (const std::string why = why_foreign(parsed.record, identity); !why.empty()) {
      foreign = "The checkpoint " + path.string() + " " + why;
      continue;
    }
    const auto generation = parsed.record.value("generation", std::uint64_t(0));
    if (!newest || generation > newest->generation)
      newest = Checkpoint{generation, parsed.record["record"].dump(), std::move(parsed.payload)};
  }
  if (damage != nullptr) *damage = sentences;
  if (!foreign.empty() && !or_none) throw InputError(foreign);
  if (!newest && !sentences.empty() && !or_none)
    throw InputError(sentences + " No usable checkpoint is left; run without --resume to start again.");
  if (newest) last_generation = newest->generation;
  return newest;
}
}  // namespace turgor

#include "micro/io/checkpoint_store.h"

#include "micro/io/atomic_file.h"
#include "micro/io/checksum.h"
#include "micro/io/number_text.h"
#include "micro/io/run_context.h"

#include <nlohmann/json.hpp>

#include <cstring>

namespace turgor
{
namespace
{
constexpr char magic[] = "TURGORcp"; // 8 bytes without the end
constexpr std::size_t head_length = 8 + 4 + 4 + 8;

template <typename Number>
void append(std::string &bytes, const Number number)
{
  bytes.append(reinterpret_cast<const char *>(&number), sizeof(number));
}

template <typename Number>
Number take(const std::string_view bytes, const std::size_t where)
{
  Number number;
  std::memcpy(&number, bytes.data() + where, sizeof(number));
  return number;
}

struct Parsed
{
  nlohmann::json record;
  std::string payload;
};

/// Throws std::runtime_error with what is wrong.
Parsed parse(const std::string &bytes)
{
  if (bytes.size() < head_length || bytes.compare(0, 8, magic, 8) != 0)
    throw std::runtime_error("it is not a checkpoint of turgor");
  const auto format = take<std::uint32_t>(bytes, 8);
  if (format != CheckpointStore::format)
    throw std::runtime_error("its format is " + number_text(format) + ", this program reads " +
                             number_text(CheckpointStore::format));
  const auto crc = take<std::uint32_t>(bytes, 12);
  const auto length = take<std::uint64_t>(bytes, 16);
  if (bytes.size() - head_length != length || length < 8)
    throw std::runtime_error("it is cut short");
  const std::string_view body(bytes.data() + head_length, length);
  if (crc32(body) != crc)
    throw std::runtime_error("its checksum is wrong");
  const auto record_length = take<std::uint64_t>(body, 0);
  if (record_length > length - 8)
    throw std::runtime_error("its record is cut short");
  return {nlohmann::json::parse(body.substr(8, record_length)), std::string(body.substr(8 + record_length))};
}
} // namespace

CheckpointStore::CheckpointStore(std::filesystem::path directory_, std::string program_version_, std::string input_hash_)
  : directory(std::move(directory_)), program_version(std::move(program_version_)), input_hash(std::move(input_hash_))
{}

void CheckpointStore::write(const nlohmann::json &record, const std::string_view payload)
{
  const std::uint64_t generation = last_generation + 1;
  const nlohmann::json full = {
    {"generation", generation}, {"version", program_version}, {"input_hash", input_hash}, {"record", record}};
  const std::string text = full.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace); // a file's name may be any bytes
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

std::optional<Checkpoint> CheckpointStore::read_newest(std::string *damage)
{
  std::optional<Checkpoint> newest;
  std::string sentences;
  for (const char *file_name : file_names)
    {
      const std::filesystem::path path = directory / file_name;
      if (!std::filesystem::exists(path))
        continue;
      Parsed parsed;
      try
        {
          parsed = parse(read_whole(path));
        }
      catch (const std::exception &problem)
        {
          sentences += (sentences.empty() ? "" : " ") + path.string() + " is damaged: " + problem.what() + ".";
          continue;
        }
      const std::string version = parsed.record.value("version", "");
      const std::string hash = parsed.record.value("input_hash", "");
      if (version != program_version)
        throw InputError("The checkpoint " + path.string() + " was written by turgor " + version + ", this is " +
                         program_version + ". Run without --resume to start again.");
      if (hash != input_hash)
        throw InputError("The checkpoint " + path.string() +
                         " belongs to another input (DIR/input.prm shows it). Resume with the same input and --set "
                         "values, choose another output directory with -o, or run without --resume to start again.");
      const auto generation = parsed.record.value("generation", std::uint64_t(0));
      if (!newest || generation > newest->generation)
        newest = Checkpoint{generation, parsed.record["record"].dump(), std::move(parsed.payload)};
    }
  if (damage != nullptr)
    *damage = sentences;
  if (!newest && !sentences.empty())
    throw InputError(sentences + " No usable checkpoint is left; run without --resume to start again.");
  if (newest)
    last_generation = newest->generation;
  return newest;
}
} // namespace turgor

#include "micro/io/manifest.h"

#include "micro/io/output_failed.h"

#include <algorithm>
#include <fstream>
#include <vector>

namespace turgor
{
namespace
{
const char *const manifest_name = "made_by_turgor.txt";

std::vector<std::string> recorded(const std::filesystem::path &directory)
{
  std::vector<std::string> names;
  std::ifstream in(directory / manifest_name);
  for (std::string line; std::getline(in, line);)
    if (!line.empty())
      names.push_back(line);
  return names;
}

/// A line that leads out of the directory was not written by record_made().
bool stays_inside(const std::filesystem::path &relative)
{
  return relative.is_relative() && std::find(relative.begin(), relative.end(), "..") == relative.end();
}
} // namespace

void record_made(const std::filesystem::path &directory, const std::string &relative_path)
{
  const std::vector<std::string> names = recorded(directory);
  if (std::find(names.begin(), names.end(), relative_path) != names.end())
    return;
  errno = 0;
  std::ofstream out(directory / manifest_name, std::ios::app);
  out << relative_path << '\n' << std::flush;
  if (!out)
    throw OutputFailed(directory / manifest_name);
}

std::size_t remove_made(const std::filesystem::path &directory)
{
  std::size_t count = 0;
  std::vector<std::string> names = recorded(directory);
  // Files of a folder were recorded after the folder: backwards, it is empty when its turn comes.
  std::reverse(names.begin(), names.end());
  for (const std::string &name : names)
    if (stays_inside(name))
      {
        std::error_code ignored;
        count += std::filesystem::remove(directory / name, ignored) ? 1 : 0;
        std::filesystem::remove(directory / (name + ".part"), ignored);
      }
  std::error_code ignored;
  std::filesystem::remove(directory / manifest_name, ignored);
  return count;
}
} // namespace turgor

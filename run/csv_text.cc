#include "run/csv_text.h"

#include "run/number_text.h"
#include "run/run_context.h"
#include "run/user_text.h"

#include <algorithm>
#include <cmath>

namespace turgor {
namespace {
/// The next row, from `place` on; moves `place` and `line` behind it. A quoted field may hold commas, quotes
/// and ends of lines.
CsvRow next_row(const std::string &text, std::size_t &place, unsigned int &line, bool &quoted) {
  CsvRow row = {line, {}};
  std::string field;
  bool was_quoted = false;
  quoted = false;
  const auto end_field = [&] {
    row.fields.push_back(was_quoted ? field : trimmed(field));
    field.clear();
    was_quoted = false;
  };
  for (; place < text.size(); ++place) {
    const char c = text[place];
    line += c == '\n' ? 1 : 0;
    if (quoted && c == '"' && place + 1 < text.size() && text[place + 1] == '"')
      field += text[place++];
    else if (quoted) {
      if (c == '"')
        quoted = false;
      else
        field += c;
    } else if (c == '"' && trimmed(field).empty()) {
      quoted = was_quoted = true;
      field.clear();
    } else if (c == ',')
      end_field();
    else if (c == '\n') {
      ++place;
      break;
    } else if (!was_quoted || !trimmed({&c, 1}).empty())
      field += c;  // behind a quote blanks are dropped, anything else makes the field a wrong one
  }
  end_field();
  return row;
}
}  // namespace

CsvText::CsvText(std::filesystem::path file_) : file(std::move(file_)) {
  const std::string text = read_text(file, std::uint64_t(1) << 32);
  unsigned int line = 1;
  bool quoted = false;
  for (std::size_t place = 0; place < text.size();) {
    if (const std::size_t first = text.find_first_not_of(" \t", place);
        first != std::string::npos && text[first] == '#') {
      place = std::min(text.find('\n', first), text.size() - 1) + 1;
      ++line;
      continue;
    }
    CsvRow row = next_row(text, place, line, quoted);
    if (quoted) refuse(row, "a quote is opened and never closed");
    if (std::all_of(row.fields.begin(), row.fields.end(),
                    [](const std::string &field) { return field.empty(); }))
      continue;
    if (header.fields.empty())
      header = std::move(row);
    else
      rows.push_back(std::move(row));
  }
  if (header.fields.empty()) throw InputError(file.string() + " is empty.");
}

void CsvText::require_fields(const CsvRow &row, const std::size_t count) const {
  if (row.fields.size() != count)
    refuse(row, "it has " + number_text(row.fields.size()) + " fields where " + number_text(count) +
                    " are needed; commas separate fields, decimals are written with a point");
}

double CsvText::number(const CsvRow &row, const std::size_t column) const {
  const std::string &field = row.fields.at(column);
  const auto value = read_number(field);
  if (!value || !std::isfinite(*value))
    refuse(row, "column " + number_text(column + 1) +
                    (column < header.fields.size() ? " (" + header.fields[column] + ")" : std::string()) +
                    " holds '" + field +
                    "' where a finite number is expected, without a unit and with a point for decimals");
  return *value;
}

void CsvText::refuse(const CsvRow &row, const std::string &what) const {
  throw InputError(file.string() + ", line " + number_text(row.line) + ": " + what + ".");
}
}  // namespace turgor

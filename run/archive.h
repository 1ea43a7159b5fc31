// What of a class lasts, named once: one list serves saving and loading.
//
//   void Plates::archive(Archive &a)
//   {
//     a.section("plates");
//     for (Plate &plate : plates)
//       a(plate.position, plate.velocity);
//     a(on_plate);
//     a.fixed(forces);                     // as many as this run has, or the checkpoint is another scene's
//     if (a.loading())
//       rebuild();                         // what follows from it
//   }
//
// Taken: plain data bit by bit; std::vector of any size, std::string, std::optional, std::array; small
// tensors of fixed size; whatever has archive(Archive &), or is such a list itself (a lambda); what a smart
// pointer points to, where it points (that follows from the input). Bytes: a section is its size (u64), the
// length of its name (u8), its name and what it holds, up to the next section; a vector is its size (u64) and
// its entries. What is outside of sections has no frame: that is how messages between ranks go. Loading
// throws ArchiveError with a sentence for what is cut short, damaged or laid out in another way; nothing is
// allocated for a length that the bytes do not have.
#pragma once

#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace turgor {
/// The bytes are not what is to be loaded from them; says what is wrong, as a sentence.
class ArchiveError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class Archive {
 public:
  Archive() = default;                       ///< saves
  explicit Archive(std::string_view bytes);  ///< loads from these bytes, which have to stay

  bool loading() const { return is_loading; }

  /// What follows belongs to the section, up to the next one.
  void section(const std::string &name);

  template <class... T>
  void operator()(T &...values) {
    (one(values), ...);
  }

  /// Vectors whose size this run knows: another one in the bytes is refused.
  template <class... T>
  void fixed(std::vector<T> &...values) {
    (one_fixed(values), ...);
  }

  /// Saving: what another archive has saved, sections and all.
  void append(std::string_view bytes);

  /// Saving: all that was saved. Loading: nothing, but it throws if something is left.
  std::string finish();

 private:
  template <class T>
  static constexpr bool has_list = requires(T &value, Archive &a) {
    value.archive(a);
  };
  // A class with a reference is trivially copyable too, but its bytes are an address: it cannot be assigned.
  template <class T>
  static constexpr bool plain =
      !has_list<T> && std::is_trivially_copyable_v<T> && std::is_copy_assignable_v<T>;

  template <class T>
  void one(T &value) {
    if constexpr (requires { T::SizeAtCompileTime; })  // a matrix of Eigen
      raw(value.data(), sizeof(*value.data()) * std::size_t(T::SizeAtCompileTime));
    else if constexpr (requires { value.begin_raw(); })  // a tensor of deal.II
      raw(value.begin_raw(), sizeof(T));
    else if constexpr (has_list<T>)
      value.archive(*this);
    else if constexpr (std::is_invocable_v<T &, Archive &>)
      value(*this);
    else if constexpr (std::is_same_v<T, bool>)
      flag(value);
    else if constexpr (plain<T>) {
      static_assert(!std::is_const_v<T> && !std::is_pointer_v<T>);
      raw(&value, sizeof(T));
    } else if constexpr (requires { value.get(); })  // a smart pointer
    {
      if (value) one(*value);
    } else
      for (auto &part : value)  // std::array
        one(part);
  }

  template <class T>
  void one(std::vector<T> &values) {
    static_assert(!std::is_same_v<T, bool>);
    std::uint64_t size = values.size();
    raw(&size, sizeof(size));
    if (is_loading) {
      require(size, plain<T> ? sizeof(T) : 1);
      if constexpr (plain<T>)
        values.resize(size);
      else
        values.clear();
    }
    if constexpr (plain<T>)
      raw(values.data(), size * sizeof(T));
    else
      for (std::uint64_t k = 0; k < size; ++k)  // one by one: a false size ends with the bytes
        one(is_loading ? values.emplace_back() : values[k]);
  }

  template <class T>
  void one(std::optional<T> &value) {
    bool there = value.has_value();
    flag(there);
    if (is_loading) there ? void(value.emplace()) : value.reset();
    if (value) one(*value);
  }

  void one(std::string &text) {
    std::uint64_t size = text.size();
    raw(&size, sizeof(size));
    if (is_loading) {
      require(size, 1);
      text.resize(size);
    }
    raw(text.data(), size);
  }

  template <class T>
  void one_fixed(std::vector<T> &values) {
    std::uint64_t size = values.size();
    raw(&size, sizeof(size));
    if (size != values.size()) other_size(size, values.size());
    if constexpr (plain<T>)
      raw(values.data(), size * sizeof(T));
    else
      for (T &value : values) one(value);
  }

  void raw(void *data, const std::size_t n) {
    if (!is_loading)
      saved.append(static_cast<const char *>(data), n);
    else {
      require(n, 1);
      if (n > 0) std::memcpy(data, bytes.data() + at, n);
      at += n;
    }
  }

  /// Loading: so many entries of so many bytes are there.
  void require(const std::uint64_t entries, const std::size_t size) const {
    if (entries > (end - at) / size) too_early();
  }

  void flag(bool &value);
  void close();
  std::string where() const;
  [[noreturn]] void too_early() const;
  [[noreturn]] void other_size(std::uint64_t there, std::size_t here) const;

  bool is_loading = false;
  std::string saved;
  std::string_view bytes;
  std::size_t at = 0, end = 0;  ///< loading: where it is, and where the section ends
  std::string name;             ///< of the section; empty: before the first
  std::size_t opened = 0;       ///< saving: where the section's size is
};

/// The bytes of these, and back.
template <class... T>
std::string archived(T &...things) {
  Archive a;
  a(things...);
  return a.finish();
}

template <class... T>
void restore(const std::string_view bytes, T &...things) {
  Archive a(bytes);
  a(things...);
  a.finish();
}
}  // namespace turgor

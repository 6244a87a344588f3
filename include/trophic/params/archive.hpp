// SPDX-License-Identifier: MIT
// Converts values to bytes and back. One function does both, so the formats cannot differ.
#pragma once

#include <bit>
#include <cstddef>
#include <cstring>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <trophic/params/params.hpp>
#include <unordered_map>
#include <vector>

namespace trophic {

class Archive;

/// A struct that lists all its members: `static constexpr auto saved() { return std::tuple{&State::steps, &State::bodies}; }`.
template <class T>
concept ListsSaved = requires {
  std::tuple_size<decltype(T::saved())>::value;
};

/// A class with private members writes and reads them in `void persist(Archive& archive) { archive(steps_, bodies_); }`.
template <class T>
concept Persists = requires(T& value, Archive& archive) {
  value.persist(archive);
};

namespace detail {

template <class T>
inline constexpr bool is_savable =
    std::is_arithmetic_v<T> || std::is_enum_v<T> || std::is_empty_v<T> || ListsSaved<T> || HasFields<T> || Persists<T>;
template <>
inline constexpr bool is_savable<std::string> = true;
template <class T>
inline constexpr bool is_savable<std::optional<T>> = is_savable<T>;
template <class T>
inline constexpr bool is_savable<std::vector<T>> = is_savable<T>;
template <class T, std::size_t size>
inline constexpr bool is_savable<std::array<T, size>> = is_savable<T>;
template <class T>
inline constexpr bool is_savable<std::shared_ptr<T>> = is_savable<T>;
template <class A, class B>
inline constexpr bool is_savable<std::pair<A, B>> = is_savable<A>&& is_savable<B>;

template <class T>
inline constexpr bool is_plain_number = std::is_arithmetic_v<T> && !std::same_as<T, bool>;

}  // namespace detail

/// The values that an Archive writes and reads: numbers, enumerations, texts, optionals, vectors, arrays, pairs and shared
/// pointers to savable values, and structs that list every member in fields() or saved(), or have persist(Archive&).
template <class T>
concept Savable = detail::is_savable<T>;

/// Writes values to bytes or reads them from bytes, depending on the constructor. `archive(a, b, c)` does either. Numbers keep
/// their bits. A value that several shared pointers share is written once and shared again after reading. Throws
/// std::invalid_argument while reading if the bytes end too early or are not such values, before it allocates more memory than
/// the bytes justify.
class Archive {
 public:
  /// Writes.
  Archive() = default;
  /// Reads these bytes, which must outlive the archive.
  explicit Archive(std::string_view bytes) : left_{bytes}, reads_{true} {}
  /// Writes and passes on the bytes in pieces, the last one in `finish`.
  explicit Archive(std::function<void(std::string_view piece)> pass_on) : pass_on_{std::move(pass_on)} {}

  [[nodiscard]] bool reads() const { return reads_; }

  template <class... T>
  void operator()(T&... values) {
    (exchange(values), ...);
  }

  /// The written bytes.
  [[nodiscard]] const std::string& bytes() const& { return written_; }
  [[nodiscard]] std::string bytes() && { return std::move(written_); }

  /// Throws std::invalid_argument if unread bytes are left. Passes on the remaining bytes to write.
  void finish() {
    if (reads_ && !left_.empty()) throw std::invalid_argument{std::to_string(left_.size()) + " bytes too many"};
    if (pass_on_) pass_on_(std::exchange(written_, {}));
  }

  /// Throws std::invalid_argument with a description of an invalid value that was read.
  static void require(bool good, std::string_view what) {
    if (!good) throw std::invalid_argument{std::string{what}};
  }

 private:
  static_assert(std::endian::native == std::endian::little, "archives are written in little-endian order");

  template <class T>
  void exchange(T& value) {
    static_assert(Savable<T>,
                  "a saved value must be a number, an enumeration, an optional, vector or array of these, or a struct that lists "
                  "every member in saved() or fields(); see trophic/params/archive.hpp");
    if constexpr (Savable<T>) exchange_savable(value);
  }

  template <class T>
  void exchange_savable(T& value) {
    if constexpr (std::same_as<T, bool>) {
      std::uint8_t byte = value ? 1 : 0;
      raw(&byte, 1);
      require(byte <= 1, "a switch that is neither true nor false");
      value = byte == 1;
    } else if constexpr (std::is_arithmetic_v<T>) {
      raw(&value, sizeof(T));
    } else if constexpr (std::is_enum_v<T>) {
      enumerator(value);
    } else if constexpr (Persists<T>) {
      value.persist(*this);
    } else if constexpr (std::is_empty_v<T>) {
      std::uint8_t nothing = 0;  // so that a list of them is not longer than its bytes
      raw(&nothing, 1);
    } else if constexpr (ListsSaved<T>) {
      static_assert(detail::AllListed<detail::member_count<T>(), std::tuple_size_v<decltype(T::saved())>>,
                    "saved() must list every member once; see trophic/params/archive.hpp");
      std::apply([&](const auto... member) { (exchange(value.*member), ...); }, T::saved());
    } else if constexpr (HasFields<T>) {
      for_each_field(value, [&](const auto&, auto& member) { exchange(member); });
    } else {
      container(value);
    }
  }

  // If this is inlined into loops over arrays, g++ 12 warns of an out-of-bounds write that does not happen.
  [[gnu::noinline]] void raw(void* value, std::size_t size) {
    if (size == 0) return;  // an empty vector has no address to copy from or to
    if (!reads_) {
      constexpr std::size_t piece_bytes = std::size_t{1} << 16U;
      const std::string_view bytes{static_cast<const char*>(value), size};
      if (!pass_on_ || written_.size() + size <= piece_bytes) return static_cast<void>(written_.append(bytes));
      finish();
      return pass_on_(bytes);
    }
    require(left_.size() >= size, "it ends too early");
    std::memcpy(value, left_.data(), size);
    left_.remove_prefix(size);
  }

  template <class E>
  void enumerator(E& value) {
    auto number = static_cast<std::underlying_type_t<E>>(value);
    raw(&number, sizeof(number));
    if constexpr (NamedEnum<E>) {
      require(static_cast<std::uint64_t>(number) < enum_names(value).size(), "an enumerator that does not exist");
    }
    value = static_cast<E>(number);
  }

  /// A number of elements, each of which takes at least one byte.
  [[nodiscard]] std::size_t count(std::size_t elements) {
    std::uint64_t number = elements;
    raw(&number, sizeof(number));
    if (reads_) require(number <= left_.size(), "it ends too early");
    return static_cast<std::size_t>(number);
  }

  void container(std::string& text) {
    text.resize(count(text.size()));
    raw(text.data(), text.size());
  }

  template <class T>
  void container(std::optional<T>& value) {
    bool has_value = value.has_value();
    exchange(has_value);
    if (!has_value) {
      value.reset();
      return;
    }
    if (!value) value.emplace();
    exchange(*value);
  }

  template <class T>
  void container(std::vector<T>& values) {
    const std::size_t size = count(values.size());
    if constexpr (detail::is_plain_number<T>) {
      if (reads_) require(size <= left_.size() / sizeof(T), "it ends too early");
      values.resize(size);
      raw(values.data(), size * sizeof(T));
    } else {
      if (reads_) values.clear();
      for (std::size_t i = 0; i < size; ++i) {
        T value = reads_ ? T{} : T(values[i]);
        exchange(value);
        if (reads_) values.push_back(std::move(value));
      }
    }
  }

  template <class T, std::size_t size>
  void container(std::array<T, size>& values) {
    for (T& value : values) exchange(value);
  }

  template <class A, class B>
  void container(std::pair<A, B>& values) {
    exchange(values.first);
    exchange(values.second);
  }

  /// 0 for a null pointer, k for the k-th object; a new object follows its number.
  template <class T>
  void container(std::shared_ptr<T>& value) {
    std::uint64_t number = 0;
    if (!reads_ && value) number = numbers_.try_emplace(value.get(), shared_.size() + 1).first->second;
    raw(&number, sizeof(number));
    if (number == 0) {
      value.reset();
      return;
    }
    require(number <= shared_.size() + 1, "a reference to a missing object");
    if (number <= shared_.size()) {
      require(shared_type_[number - 1] == type_of<T>(), "a reference to an object of a different type");
      value = std::static_pointer_cast<T>(shared_[number - 1]);
      return;
    }
    if (reads_) value = std::make_shared<T>();
    shared_.push_back(value);
    shared_type_.push_back(type_of<T>());
    exchange(*value);
  }

  /// A unique number per type.
  template <class T>
  [[nodiscard]] static const void* type_of() {
    static const char own = 0;
    return &own;
  }

  std::string written_;
  std::function<void(std::string_view)> pass_on_;
  std::string_view left_;
  bool reads_ = false;
  std::unordered_map<const void*, std::uint64_t> numbers_;
  std::vector<std::shared_ptr<void>> shared_;
  std::vector<const void*> shared_type_;
};

}  // namespace trophic

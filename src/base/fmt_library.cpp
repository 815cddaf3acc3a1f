// fmt's own functions, and those instances of its templates that its headers declare to be elsewhere. Debian has them
// in a shared library only, which a start would have to load, and the C++ library with it: see "A quick start" in
// docs/architecture.md. The list is that of fmt 9, `src/format.cc`.
#include <fmt/format-inl.h>

static_assert(FMT_VERSION / 10000 == 9, "another version of fmt: see which templates its src/format.cc makes");

FMT_BEGIN_NAMESPACE
namespace detail {
template dragonbox::decimal_fp<float> dragonbox::to_decimal(float number) noexcept;
template dragonbox::decimal_fp<double> dragonbox::to_decimal(double number) noexcept;
template locale_ref::locale_ref(const std::locale& locale);
template std::locale locale_ref::get<std::locale>() const;
template thousands_sep_result<char> thousands_sep_impl(locale_ref locale);
template char decimal_point_impl(locale_ref locale);
template void buffer<char>::append(const char* begin, const char* end);
template void vformat_to(buffer<char>& out, string_view format, basic_format_args<buffer_context<char>> values,
                         locale_ref locale);
}  // namespace detail
FMT_END_NAMESPACE

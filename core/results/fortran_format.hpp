#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

/// Fortran edit descriptors for the classic files, both ways, independent of any locale (N103).
///
/// Written as a Fortran program writes: fields are right-justified, a value that does not fit
/// becomes stars, an exponent of three digits loses its letter ("1.2345678-100").
namespace adore::results::fortran {

/// Position of the decimal point: Ew.d writes 0.1234568E+01, the 1p scale factor 1.2345678E+00.
enum class Scale : unsigned char { Zero, One };

/// Appends iw. Stars when the number needs more than `width` columns.
void append_integer(std::string& out, long long value, int width);

/// Appends Ew.d or 1pEw.d, correctly rounded. Not-a-number and infinities are written as words
/// ("NaN", "Infinity" or "Inf"), everything that does not fit as stars. -0 is written as 0.
void append_real(std::string& out, double value, int width, int digits, Scale scale);

/// Appends a field for each value, as append_real() does, `per_line` to a line; `between` ends a
/// line and begins the next one.
void append_reals(std::string& out, std::span<const double> values, int width, int digits,
                  Scale scale, int per_line, std::string_view between);

/// Appends aw: the text from the left, blanks after it, cut at `width` columns.
void append_text(std::string& out, std::string_view text, int width);

/// The columns first..last (counted from 1) of a line; shorter, or empty, where the line ends
/// early.
[[nodiscard]] std::string_view columns(std::string_view line, int first, int last);

/// Text without leading and trailing blanks.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// Reads one field. Understands 1.5, 1.5E+00, 1.5D+00, 1.5-100, +1, .5, NaN, Inf, Infinity; a field
/// of stars is a missing value: NaN. Empty optional: blank, or no number. Too large a number
/// becomes infinite, too small a one 0.
[[nodiscard]] std::optional<double> parse_real(std::string_view field);

/// Reads one integer field. Empty optional: blank, stars, no integer, or out of range.
[[nodiscard]] std::optional<long long> parse_integer(std::string_view field);

}  // namespace adore::results::fortran

#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

/// Fortran list-directed input: commas and blanks separate, a line end counts as a blank, two
/// commas hold a null value, `r*value` repeats, `r*` repeats nulls, `/` ends the record.
namespace adore::deck {

struct Token {
  enum class Kind : unsigned char {
    Word,    ///< unquoted text: a number, or a mistake
    Quoted,  ///< text in quotes, with doubled quotes made single
    Null,    ///< nothing between two separators
    Slash,
    End  ///< no more text
  };
  Kind kind = Kind::End;
  std::string text;
  long long repeat = 1;        ///< r of r*value; 10^15 where it is more
  int line = 0;                ///< 1-based
  bool first_in_line = false;  ///< nothing but blanks before it on its line
  bool unterminated = false;   ///< the closing quote is missing; the text runs to the line's end
  bool joined = false;         ///< text follows the closing quote directly
};

class Scanner {
 public:
  /// Splits into lines at LF, CRLF or CR. The text must outlive the scanner.
  explicit Scanner(std::string_view text);

  /// Read position; copy it to return there.
  struct Position {
    std::size_t line = 0;  ///< 0-based
    std::size_t column = 0;
    bool after_value = false;  ///< the next comma is only a separator
  };
  [[nodiscard]] Position position() const { return read_position_; }
  void set_position(const Position& position) { read_position_ = position; }

  /// Drops the rest of a started line, then skips blank lines. False at the end of the
  /// text.
  bool skip_to_record_start();
  /// Goes to the first column of a line (0-based).
  void go_to_line(std::size_t line) { read_position_ = {line, 0, false}; }

  /// The next token, on following lines if need be.
  Token next();

  [[nodiscard]] const std::vector<std::string_view>& lines() const { return *lines_; }
  /// Is the position exactly at the end of a text whose last line has no line end?
  [[nodiscard]] bool is_at_unterminated_end() const;
  /// The rest of the current line.
  [[nodiscard]] std::string_view rest_of_line() const;

 private:
  bool skip_blanks();  // false at the end of the text
  void scan_quoted(Token& token);
  void scan_word(Token& token);

  std::shared_ptr<const std::vector<std::string_view>>
      lines_;  ///< copies of the scanner share them
  Position read_position_;
  bool lacks_final_newline_ = false;  // the last line has no line end
};

bool is_blank_line(std::string_view line);

}  // namespace adore::deck

#pragma once

#include "base/write_folder.hpp"

#include <QByteArray>
#include <QImage>
#include <QString>

#include <filesystem>
#include <string>
#include <string_view>

/// Pictures on disk and on paper.
namespace adore::desktop {

/// What a picture may replace: what this program made before, or whatever the user was asked about.
enum class Replace : unsigned char { OwnPictures, Anything };

/// Writes PNG or JPEG by the name's suffix (.png, .jpg, .jpeg), replacing an old file only when the
/// new one is complete. The picture says that this program made it.
/// @throws InputError when the suffix is none of these, the file cannot be written, or another one
/// is there that may not be replaced.
void save_image(const QImage& image, const WritePath& place,
                Replace replace = Replace::OwnPictures);

/// Writes a document whole or not at all. @throws InputError when that is impossible
void save_bytes(const QByteArray& bytes, const WritePath& place);
[[nodiscard]] std::string_view text_of(const QByteArray& bytes);

/// Throws unless there is no such file, or one that save_image() or AviWriter made: neither another
/// program's picture nor a symbolic link. @throws InputError naming it
void check_replaceable(const std::filesystem::path& path);

/// Makes a folder and its parents. @throws InputError when that fails.
void make_folder(const std::filesystem::path& folder);

/// "plot.jpg" -> "plot-2.jpg" -> "plot-3.jpg": the name to propose after a picture was saved under
/// `previous`; goes on counting while the file exists already.
QString next_image_name(const QString& previous);

/// The proposal for a picture of what has the name `shown`, remembered across sessions: that name,
/// or where it is taken with a number of its own ("SOL1-page-6.jpg", "SOL1-page-6-2.jpg"), in the
/// folder where pictures of the same folder went last. A name of somebody's own counts on while the
/// same is shown.
QString proposed_image_name(const QString& app, const QString& shown);
void remember_image_name(const QString& app, const QString& shown, const QString& saved);

}  // namespace adore::desktop

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

/// Files that a picture may replace: those written by this program, or any file that the user has
/// confirmed.
enum class Replace : unsigned char { OwnPictures, Anything };

/// Writes PNG or JPEG by the suffix of the name (.png, .jpg, .jpeg); replaces an old file only when
/// the new one is complete. The picture names this program as its source.
/// @throws InputError if the suffix is none of these, the file cannot be written, or a file exists
/// that may not be replaced.
void save_image(const QImage& image, const WritePath& place,
                Replace replace = Replace::OwnPictures);

/// Writes a document whole or not at all. @throws InputError when that is impossible
void save_bytes(const QByteArray& bytes, const WritePath& place);
[[nodiscard]] std::string_view text_of(const QByteArray& bytes);

/// Throws unless the file does not exist or was written by save_image() or AviWriter: neither
/// another program's picture nor a symbolic link. @throws InputError naming it
void check_replaceable(const std::filesystem::path& path);

/// Makes a folder and its parents. @throws InputError when that fails.
void make_folder(const std::filesystem::path& folder);

/// "plot.jpg" -> "plot-2.jpg" -> "plot-3.jpg": the name to propose after a picture was saved under
/// `previous`; counts further while the file exists.
QString next_image_name(const QString& previous);

/// The proposed name for a picture of `shown`, remembered across sessions: that name, or with a
/// number if it exists ("SOL1-page-6.jpg", "SOL1-page-6-2.jpg"), in the folder of the last pictures
/// of the same folder. A name chosen by the user is counted on while the same is shown.
QString proposed_image_name(const QString& app, const QString& shown);
void remember_image_name(const QString& app, const QString& shown, const QString& saved);

}  // namespace adore::desktop

// SPDX-License-Identifier: Apache-2.0
// Films of numbered pictures, by the program ffmpeg where it is installed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "meristem/base/progress.h"

namespace meristem::film {

/// Whether a file of that name is a film: it ends in .mp4 or .webm.
bool is_film(const std::string& path);

/// Whether the program that makes films is installed.
bool can_make_films();

/// Throws InputError where a film cannot be made: ffmpeg is not installed, or the picture's width or height is odd.
void check_film(const std::string& path, int width, int height);

/// The folder beside a film in which its pictures wait. It is named by what they show, so that a film that was stopped
/// goes on where it was, and one of anything else begins anew. Makes the folder; throws MachineError.
std::string frames_folder(const std::string& path, std::uint64_t what_they_show);

/// The picture of that number in the folder.
std::string frame_path(const std::string& folder, std::size_t frame);

/// Puts the pictures of a folder together, at that many per second; the film appears whole or not at all. Then it
/// removes the folder. Throws MachineError with what ffmpeg says, and Cancelled, which ends ffmpeg.
void make_film(const std::string& folder, std::size_t frames, double fps, const std::string& path,
               const Progress& progress);

}  // namespace meristem::film

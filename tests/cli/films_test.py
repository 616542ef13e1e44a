#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Films that `meristem render` makes. A small script replaces ffmpeg, which need not be installed.

Usage: films_test.py PROGRAM [unittest options]
"""

import os
import shutil
import subprocess
import unittest

import cli_case
from cli_case import DONE, FAILED, PROGRAM, WRONG_INPUT

RISING = """{"meristem": 1,
  "components": {"b": {"type": "simple", "size": [1, 1, 1]}},
  "animation": {"length": 0.5, "fps": 10, "keys": {"b.size[1]": [[0, 0.5], [0.5, 2]]}}}"""

# Records its arguments, and fails if a certain file exists.
MAKER = """#!/bin/sh
echo "$@" >>"{folder}/calls.txt"
if [ -e "{folder}/broken" ]; then echo "no such codec" >&2; exit 3; fi
for last; do :; done
ls "$(dirname "$last")" | grep -c png >"$last"
"""

SIZE = ["--size", "16x16", "--samples", "1"]


class Films(cli_case.Case):
    def setUp(self):
        super().setUp()
        self.write("rising.json", RISING)
        self.bin = os.path.join(self.folder, "bin")
        os.mkdir(self.bin)

    def install(self):
        path = os.path.join(self.bin, "ffmpeg")
        with open(path, "w", encoding="utf-8") as file:
            file.write(MAKER.format(folder=self.folder))
        os.chmod(path, 0o755)

    def render(self, *options):
        """Runs the program with a PATH that contains the script, if it is installed, and the shell's own commands."""
        path = self.bin if not os.listdir(self.bin) else self.bin + ":/usr/bin:/bin"
        return subprocess.run([PROGRAM, "render", "rising.json", *options, *SIZE], cwd=self.folder, check=False,
                              env={**os.environ, "PATH": path}, stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=120)

    def folders(self):
        return [name for name in os.listdir(self.folder) if name.endswith(".frames")]

    def test_without_ffmpeg_the_message_says_what_to_do(self):
        done = self.render("-o", "film.mp4")
        self.assertEqual(done.returncode, WRONG_INPUT)
        self.assertIn("needs the program ffmpeg, which is not installed", done.stderr.decode())
        self.assertIn("numbered pictures", done.stderr.decode())
        self.assertEqual(self.folders(), [])

    def test_a_film_shows_the_whole_animation(self):
        self.install()
        done = self.render("-o", "film.mp4")
        self.assertEqual(done.returncode, DONE, done.stderr)
        self.assertIn("film.mp4: 6 frames: 16 x 16 pixels", done.stderr.decode())
        self.assertEqual(self.read("film.mp4").decode().strip(), "6")
        call = self.read("calls.txt").decode()
        self.assertIn("-framerate 10 ", call)
        self.assertIn("libx264", call)
        self.assertEqual(self.folders(), [], "the frames go when the film is there")

    def test_times_may_be_given_and_webm_has_a_codec_of_its_own(self):
        self.install()
        self.assertEqual(self.render("-o", "film.webm", "--time", "0:0.4:0.2").returncode, DONE)
        self.assertEqual(self.read("film.webm").decode().strip(), "3")
        call = self.read("calls.txt").decode()
        self.assertIn("-framerate 5 ", call)
        self.assertIn("libvpx-vp9", call)

    def test_a_film_that_failed_goes_on_with_its_frames(self):
        self.install()
        self.write("broken", "")
        done = self.render("-o", "film.mp4")
        self.assertEqual(done.returncode, FAILED)
        self.assertIn("no such codec", done.stderr.decode())
        self.assertNotIn("film.mp4", os.listdir(self.folder))
        [frames] = self.folders()
        first = os.path.join(self.folder, frames, "00000.png")
        before = os.stat(first).st_mtime_ns
        os.remove(os.path.join(self.folder, frames, "00003.png"))
        # Existing frames are kept; another size starts again.
        self.assertEqual(self.render("-o", "film.mp4").returncode, FAILED)
        self.assertEqual(os.stat(first).st_mtime_ns, before)
        self.assertIn("00003.png", os.listdir(os.path.join(self.folder, frames)))
        self.assertEqual(self.render("-o", "film.mp4", "--view", "10,10").returncode, FAILED)
        self.assertEqual(len(self.folders()), 2)

    def test_what_no_film_can_be_is_refused(self):
        self.install()
        for options, message in ((["--size", "15x16"], "a film cannot have 15 x 16 pixels"),
                                 (["--transparent"], "a film has no alpha channel")):
            done = subprocess.run([PROGRAM, "render", "rising.json", "-o", "film.mp4", "--samples", "1", *options],
                                  cwd=self.folder, check=False, env={**os.environ, "PATH": self.bin},
                                  stderr=subprocess.PIPE, timeout=60)
            self.assertEqual(done.returncode, WRONG_INPUT)
            self.assertIn(message, done.stderr.decode())
        done = self.run_program("render", "box.json", "-o", "film.mp4")
        self.assertEqual(done.returncode, WRONG_INPUT)
        self.assertIn("no animation", done.stderr.decode())


@unittest.skipUnless(shutil.which("ffmpeg"), "ffmpeg is not installed")
class RealFilms(cli_case.Case):
    def test_ffmpeg_makes_films_of_both_kinds(self):
        self.write("rising.json", RISING)
        for name, begin in (("film.mp4", b"ftyp"), ("film.webm", b"\x1a\x45\xdf\xa3")):
            done = self.run_program("render", "rising.json", "-o", name, *SIZE)
            self.assertEqual(done.returncode, DONE, done.stderr)
            self.assertIn(begin, self.read(name)[:16])


class Animated(cli_case.Case):
    def test_an_animation_is_one_file(self):
        self.write("rising.json", RISING)
        done = self.run_program("grow", "rising.json", "--animated", "--keys", "3", "-o", "rising.glb")
        self.assertEqual(done.returncode, DONE, done.stderr)
        self.assertIn("rising.glb: 3 keys over 0.5 s, 12 triangles", done.stderr.decode())
        self.assertIn(b'"name":"growth"', self.read("rising.glb"))

    def test_what_cannot_be_animated_is_refused(self):
        self.write("rising.json", RISING)
        for options, message in ((["--keys", "3", "-o", "a.glb"], "--keys changes none of the files"),
                                 (["--animated", "-o", "a.obj"], "'a.obj' cannot hold an animation"),
                                 (["--animated", "--time", "1", "-o", "a.glb"], "--time cannot stand with --animated"),
                                 (["--animated", "--step", "3", "-o", "a.glb"], "--step cannot stand with --animated"),
                                 (["--animated", "--keys", "1", "-o", "a.glb"], "--keys cannot be 1"),
                                 (["--animated", "--lod", "1", "-o", "a.glb"], "--lod cannot stand with --animated")):
            done = self.run_program("grow", "rising.json", *options)
            self.assertEqual(done.returncode, WRONG_INPUT, options)
            self.assertIn(message, done.stderr.decode())
        done = self.run_program("grow", "box.json", "--animated", "-o", "a.glb")
        self.assertEqual(done.returncode, WRONG_INPUT)
        self.assertIn("the document has no animation", done.stderr.decode())


class Keys(cli_case.Case):
    def test_a_time_is_the_document_with_its_values_put_in(self):
        self.write("rising.json", RISING)
        self.run_program("grow", "rising.json", "-o", "keyed.obj", "--time", "0.25", "--quiet")
        plain = RISING[:RISING.index(",\n  \"animation\"")].replace("[1, 1, 1]", "[1, 1.25, 1]") + "}"
        self.write("plain.json", plain)
        self.run_program("grow", "plain.json", "-o", "plain.obj", "--quiet")

        def shape(name):
            return [line for line in self.read(name).decode().splitlines() if line.startswith(("v", "f"))]

        self.assertEqual(shape("keyed.obj"), shape("plain.obj"))

    def test_check_tells_the_nearest_name_and_the_place_of_a_key(self):
        self.write("wrong.json", RISING.replace("b.size[1]", "b.siz[1]"))
        done = self.run_program("check", "wrong.json")
        self.assertEqual(done.returncode, WRONG_INPUT)
        self.assertIn("wrong.json:3:", done.stderr.decode())
        self.assertIn("'size'", done.stderr.decode())

    def test_shipped_films_are_models(self):
        names = self.run_program("models", "--names").stdout.decode().split()
        for film in ("primrose", "tulip-day", "oak-life", "ivy-climb", "crocus"):
            self.assertIn(film, names)
        self.assert_ends(DONE, "grow", "primrose", "--animated", "--keys", "3", "-o", "p.glb", "-q")
        self.assertIn(b'"animations"', self.read("p.glb"))


if __name__ == "__main__":
    unittest.main(verbosity=2)

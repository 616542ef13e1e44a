# SPDX-License-Identifier: Apache-2.0
"""The studio over its sockets: what is refused, and what a page gets. Things are counted, and nothing is timed.

In:  the program; the folder of the source tree; the program that compares messages with the protocol.
"""

from __future__ import annotations

import contextlib
import io
import itertools
import json
import select
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest
import zipfile
from pathlib import Path

from studio_client import Closed, Page, Studio, check_recorded, read_response, upgrade

PROGRAM, SOURCE, PROTOCOL = sys.argv[1], Path(sys.argv[2]), sys.argv[3]
BUSH = """{
  "meristem": 1,
  "components": {
    "stem": {"type": "tree", "length": 1.5, "radius": 0.01},
    "leaf": {"type": "leaf", "length": 0.1, "width": 0.03, "colour": "#337722"}
  },
  "links": [{"from": "stem", "to": "leaf", "kind": "branch", "count": 40}]
}
"""


class StudioTest(unittest.TestCase):
    studio: Studio
    folder: tempfile.TemporaryDirectory[str]

    @classmethod
    def setUpClass(cls) -> None:
        cls.folder = tempfile.TemporaryDirectory()
        (Path(cls.folder.name) / "bush.json").write_text(BUSH)
        cls.studio = Studio(PROGRAM, Path(cls.folder.name))

    @classmethod
    def tearDownClass(cls) -> None:
        cls.studio.__exit__()
        faults = check_recorded(PROTOCOL, Path(cls.folder.name))
        cls.folder.cleanup()
        assert not faults, "\n".join(["messages are not as the protocol describes them", *faults])

    # Many more connections than the server keeps without the secret.
    FLOOD = 200
    MAX_UNAUTHENTICATED = 32

    def test_connections_without_the_secret_keep_no_page_out(self) -> None:
        with Studio(PROGRAM, Path(self.folder.name)) as studio, contextlib.ExitStack() as stack:
            flood = [stack.enter_context(studio.connect()) for _ in range(self.FLOOD)]
            slow = [stack.enter_context(studio.connect()) for _ in range(8)]
            begin = time.monotonic()
            self.assertEqual(studio.get("tables.json").status, 200)
            with studio.page() as page:
                self.assertLess(time.monotonic() - begin, 10)
                # Each new connection takes the place of the oldest one.
                open_ones = [one for one in flood if not select.select([one], [], [], 0)[0]]
                self.assertLess(len(open_ones), self.MAX_UNAUTHENTICATED)
                self.assertEqual(open_ones, flood[-len(open_ones):])
                # The others end soon, whether they are silent or send a byte now and then.
                left, head = [*open_ones, *slow], itertools.cycle(b"GET /index.html HTTP/1.1")
                while left and time.monotonic() - begin < 20:
                    byte = bytes([next(head)])
                    for one in slow:
                        with contextlib.suppress(OSError):
                            one.sendall(byte)
                    left = [one for one in left if not select.select([one], [], [], 0)[0]]
                    time.sleep(0.1)
                self.assertEqual(left, [])
                self.assertEqual(page.ask("models")["is"], "done")

    def test_pages_are_served_while_others_go_on_to_connect(self) -> None:
        with Studio(PROGRAM, Path(self.folder.name)) as studio, contextlib.ExitStack() as stack:
            for _ in range(20):
                for _ in range(self.MAX_UNAUTHENTICATED):
                    stack.enter_context(studio.connect())
                self.assertEqual(studio.get("tables.json").status, 200)

    def test_a_connection_with_the_secret_stays_open_for_more(self) -> None:
        with Studio(PROGRAM, Path(self.folder.name)) as studio, contextlib.ExitStack() as stack:
            kept = stack.enter_context(studio.connect())
            stream = kept.makefile("rb")
            request = f"GET /{studio.token}/tables.json HTTP/1.1\r\nHost: 127.0.0.1:{studio.port}\r\n\r\n".encode()
            kept.sendall(request)
            self.assertEqual(read_response(stream).status, 200)
            for _ in range(self.FLOOD):
                stack.enter_context(studio.connect())
            kept.sendall(request)
            self.assertEqual(read_response(stream).status, 200)

    # Notes what a browser is started with: its arguments, its sockets, and the page that it is to open.
    BROWSER = """#!/bin/sh
printf '%s\\n' "$@" >{notes}/arguments
for one in /proc/$$/fd/*; do
  [ "${{one##*/}}" -le 2 ] || readlink "$one" | grep socket:
done >{notes}/sockets
stat -c '%a %n' "$1" "$(dirname "$1")" >{notes}/modes
cp "$1" {notes}/page
mv {notes}/page {notes}/page.html
"""

    def test_the_browser_is_given_a_private_page_in_place_of_the_secret(self) -> None:
        with tempfile.TemporaryDirectory() as notes_folder:
            notes = Path(notes_folder)
            (notes / "bin").mkdir()
            (notes / "temporary").mkdir()
            browser = notes / "bin" / "xdg-open"
            browser.write_text(self.BROWSER.format(notes=notes))
            browser.chmod(0o755)
            desktop = {"DISPLAY": ":0", "PATH": f"{browser.parent}:/usr/bin:/bin", "TMPDIR": str(notes / "temporary")}
            with Studio(PROGRAM, Path(self.folder.name), environment=desktop) as studio:
                while not (notes / "page.html").exists():
                    self.assertIsNone(studio.process.poll())
                    time.sleep(0.02)
                self.assertIn(f'content="0; url={studio.address}"', (notes / "page.html").read_text())
                path = (notes / "arguments").read_text().strip()
                self.assertEqual((notes / "modes").read_text().split("\n")[:2], [f"600 {path}", f"700 {Path(path).parent}"])
                self.assertNotIn(studio.token, path)
                # A browser that outlives the studio would hold the studio's port.
                self.assertEqual((notes / "sockets").read_text(), "")
                for words in Path("/proc").glob("[0-9]*/cmdline"):
                    with contextlib.suppress(OSError):
                        self.assertNotIn(studio.token.encode(), words.read_bytes(), words)
                self.assertTrue(Path(path).exists())
                with studio.page() as page:
                    studio.process.send_signal(signal.SIGINT)
                    with self.assertRaises(Closed):
                        page.wait(lambda message: False)
                    # The private page is removed first, because the program may end before its work does.
                    self.assertEqual(list((notes / "temporary").iterdir()), [])
                self.assertEqual(studio.process.wait(timeout=60), 0)

    def test_serves_without_a_place_for_the_browsers_page(self) -> None:
        desktop = {"DISPLAY": ":0", "TMPDIR": "/dev/null/nowhere"}
        with Studio(PROGRAM, Path(self.folder.name), environment=desktop) as studio:
            self.assertEqual(studio.get("tables.json").status, 200)
            self.assertEqual(studio.stop(), 0)
            assert studio.process.stderr is not None
            self.assertIn("no browser was opened", studio.process.stderr.read())

    def test_says_the_secret_nowhere_but_in_its_own_line(self) -> None:
        with Studio(PROGRAM, Path(self.folder.name)) as studio:
            answers = [studio.get(path) for path in ("", "nothing", "socket", "/", "page.js")]
            for response in answers:
                self.assertEqual(response.headers["referrer-policy"], "no-referrer")
                self.assertNotIn(studio.token, str(response.headers))
                self.assertNotIn(studio.token.encode(), response.body)
            with studio.page() as page:
                page.ask("open", path="bush.json")
                page.ask("command", format=".glb", name="bush")
                page.ask("export", format=".glb", name="bush")
                self.assertNotIn(studio.token, json.dumps(page.messages))
            self.assertEqual(studio.stop(), 0)
            for stream in (studio.process.stdout, studio.process.stderr):
                assert stream is not None
                self.assertNotIn(studio.token, stream.read())

    def test_serves_tables_with_headers_that_keep_a_page_safe(self) -> None:
        response = self.studio.get("tables.json")
        self.assertEqual(response.status, 200)
        self.assertIn("leaf", json.loads(response.body)["components"])
        policy = response.headers["content-security-policy"]
        self.assertIn("default-src 'none'", policy)
        self.assertIn("frame-ancestors 'none'", policy)
        self.assertNotIn("unsafe-inline", policy.split("style-src")[0])
        self.assertNotIn("unsafe-eval", policy)
        self.assertEqual(response.headers["x-content-type-options"], "nosniff")
        self.assertEqual(response.headers["referrer-policy"], "no-referrer")
        self.assertEqual(response.headers["cache-control"], "no-store")
        self.assertNotIn("set-cookie", response.headers)

    def test_gives_nothing_without_the_token(self) -> None:
        wrong = ("0" if self.studio.token[0] != "0" else "1") + self.studio.token[1:]
        for path in ("/", "/index.html", f"/{self.studio.token}", f"/{wrong}/", f"/{wrong}/tables.json", "/favicon.ico",
                     f"/{self.studio.token}/../", f"/{self.studio.token}/..%2f", f"/{self.studio.token}/.git/config",
                     f"/{self.studio.token}//etc/passwd", f"/{self.studio.token}/downloads/1/x",
                     f"/{self.studio.token}/downloads/1/..%2fx", f"/{self.studio.token}/nothing"):  # fmt: skip
            response = self.studio.get(path)
            self.assertEqual(response.status, 404, path)
            self.assertIn("content-security-policy", response.headers)

    def test_answers_to_its_own_name_alone(self) -> None:
        port = self.studio.port
        for host in (f"127.0.0.1:{port}", f"localhost:{port}", f"[::1]:{port}"):
            self.assertEqual(self.studio.get("tables.json", host=host).status, 200, host)
        for host in ("127.0.0.1", "localhost", f"evil.example:{port}", f"127.0.0.1:{port + 1}", f"127.0.0.1.nip.io:{port}"):
            self.assertEqual(self.studio.get("tables.json", host=host).status, 403, host)
        target = f"GET /{self.studio.token}/tables.json HTTP/1.1\r\n"
        twice = f"Host: 127.0.0.1:{port}\r\nHost: evil.example\r\n\r\n"
        self.assertEqual(self.studio.raw((target + "\r\n").encode()).status, 403)
        self.assertIn(self.studio.raw((target + twice).encode()).status, (400, 403, 0))

    def test_takes_no_other_methods_and_no_bodies(self) -> None:
        for method in ("POST", "PUT", "DELETE", "OPTIONS"):
            self.assertEqual(self.studio.get("tables.json", method=method).status, 405, method)
        self.assertIn(self.studio.get("tables.json", method="POST", Content_Length="10").status, (413, 0))
        self.assertIn(self.studio.get("tables.json", X="y" * 20000).status, (431, 0))

    def test_opens_sockets_for_its_own_page_alone(self) -> None:
        port = self.studio.port
        for origin in (None, "null", "http://evil.example", f"https://127.0.0.1:{port}", f"http://127.0.0.1:{port + 1}",
                       "http://127.0.0.1"):  # fmt: skip
            connection, _, response = upgrade(self.studio, origin)
            connection.close()
            self.assertEqual(response.status, 403, origin)
        connection, _, response = upgrade(self.studio, f"http://127.0.0.1:{port}", host="evil.example")
        connection.close()
        self.assertEqual(response.status, 403)
        self.assertEqual(self.studio.get("socket").status, 426)

    def test_listens_on_this_machine_alone(self) -> None:
        other = next((address for *_, (address, *_) in socket.getaddrinfo(socket.gethostname(), None, socket.AF_INET)
                      if not address.startswith("127.")), None)  # fmt: skip
        if other is None:
            self.skipTest("this machine has no other address")
        with self.assertRaises(OSError):
            socket.create_connection((other, self.studio.port), timeout=5).close()

    def test_shows_a_document_and_then_only_what_changes(self) -> None:
        with self.studio.page() as page:
            answer = page.ask("open", path="bush.json")
            self.assertEqual(answer["text"], BUSH)
            head, _ = page.show()
            self.assertTrue(head["whole"])
            self.assertGreater(head["triangles"], 40)
            page.edit({"set": "leaf.colour", "value": "#ff0000"})
            head, size = page.show()
            self.assertFalse(head["whole"])
            self.assertLess(size, 2000)

    def test_shows_the_last_of_many_values(self) -> None:
        with self.studio.page() as page:
            page.ask("open", path="bush.json")
            page.show()
            before = len(page.packets)
            for k in range(100):
                page.send("drag", values={"leaf.width": 0.02 + k * 1e-4})
            page.ask("view")
            page.edit({"set": "leaf.width", "value": 0.05})
            page.show()
            self.assertLess(len(page.packets) - before, 100)

    def test_of_the_oak_only_what_an_edit_changes_crosses(self) -> None:
        with self.studio.page() as page:
            page.ask("view", rest_triangles=1_000_000_000)
            page.ask("open", model="oak")
            page.show()
            # Bark is painted in shades of its colour, so its tint is enough; the veins of leaves are not.
            for component, pictures in (("tree", 0), ("leaf", 1)):
                page.edit({"set": f"{component}.colour", "value": "#8a5a30"})
                head, size = page.show()
                crossed = [picture["bytes"][1] for picture in head.get("pictures", [])]
                self.assertEqual(len(crossed), pictures)
                self.assertEqual(len(head["materials"]), 1)
                self.assertLess(size - sum(crossed), 2_000)
                for member in ("meshes", "instances_of", "batches"):
                    self.assertNotIn(member, head)
            for path, value in (("leaf.curl", 40), ("leaf.length", 0.2), ("links[1].density", 50)):
                page.edit({"set": path, "value": value})
                head, size = page.show()
                # A longer leaf has other proportions, so it is painted anew.
                pictures = sum(picture["bytes"][1] for picture in head.get("pictures", []))
                self.assertLess(size - pictures, 1_300_000, path)

    def test_names_the_limit_of_each_refusal(self) -> None:
        with self.studio.page() as page:
            self.assertEqual(page.hello["limits"]["message_bytes"], 17_000_000)
            for _ in range(250):
                page.send("view")
            refused = page.wait(lambda message: message["is"] == "refused")
            self.assertEqual(refused["limit"], "messages_per_second")
            self.assertIn("200", refused["message"])
        with self.studio.page() as page:
            page.send_frame(1, b" " * 17_000_001)
            refused = page.wait(lambda message: message["is"] == "refused")
            self.assertEqual(refused["limit"], "message_bytes")
            self.assertIn("17000000", refused["message"])
            with self.assertRaises((Closed, OSError)):
                page.send_frame(1, b" " * 20_000_000)
                page.wait(lambda message: False)

    def test_takes_as_many_pages_as_it_says(self) -> None:
        with Studio(PROGRAM, Path(self.folder.name)) as studio:
            pages: list[Page] = [studio.page() for _ in range(8)]
            connection, _, response = upgrade(studio, f"http://127.0.0.1:{studio.port}")
            connection.close()
            self.assertEqual(response.status, 503)
            for page in pages:
                page.__exit__()

    def test_says_no_to_what_is_no_request(self) -> None:
        with self.studio.page() as page:
            for payload in (b"", b"{", b"[]", b'{"do": "open"}', b'{"do": "dance", "id": 1}'):
                page.send_frame(1, payload)
                self.assertEqual(page.wait(lambda _: True)["is"], "refused")
            page.send_frame(2, b"bytes")
            self.assertEqual(page.wait(lambda _: True)["is"], "refused")
            self.assertEqual(page.ask("models")["is"], "done")

    def test_reads_and_writes_below_its_folder_alone(self) -> None:
        with self.studio.page() as page:
            for path in ("/etc/passwd", "../x.json", str(SOURCE / "models" / "oak.json")):
                self.assertEqual(page.ask("open", path=path)["is"], "refused", path)
                self.assertEqual(page.ask("files", folder=path)["is"], "refused", path)
            bush = page.ask("open", path="bush.json")
            refused = page.ask("save", path="../x.json", hash=bush["hash"], saved=None)
            self.assertIn("outside the folder", refused["message"])
            named = page.ask("open", text='{"meristem": 1, "components": {"a": {"type": "lsystem", "file": "/etc/hostname"}}}')
            self.assertFalse(named["good"])
            self.assertIn("outside the folder", json.dumps(named["faults"]))

    def test_refuses_files_that_are_not_utf8_and_goes_on(self) -> None:
        (Path(self.folder.name) / "latin.json").write_bytes('{"meristem": 1,\n "author": "Köhler"}'.encode("latin-1"))
        with self.studio.page() as page:
            refused = page.ask("open", path="latin.json")
            self.assertIn("byte 0xf6 in line 2 (byte 30 of the file) is not UTF-8", refused["message"])
            self.assertEqual(page.ask("open", path="bush.json")["is"], "done")

    def test_exports_downloads(self) -> None:
        with self.studio.page() as page:
            page.ask("open", path="bush.json")
            answer = page.ask("export", format=".glb", name="bush")
            file = answer["file"]
            response = self.studio.get(file["address"])
            self.assertEqual(response.status, 200)
            self.assertEqual(len(response.body), file["bytes"])
            self.assertEqual(response.body[:4], b"glTF")
            self.assertIn("attachment", response.headers["content-disposition"])

    def test_exports_of_several_files_download_as_one_archive(self) -> None:
        with self.studio.page() as page:
            page.ask("open", model="oak")
            file = page.ask("export", format=".obj", name="oak")["file"]
            self.assertEqual(file["name"], "oak.zip")
            archive = zipfile.ZipFile(io.BytesIO(self.studio.get(file["address"]).body))
            self.assertIsNone(archive.testzip())
            self.assertEqual(archive.namelist(), file["holds"])
            self.assertEqual(file["holds"][0], "oak.obj")
            materials = archive.read("oak.mtl").decode()
            for name in file["holds"]:
                if name.endswith((".png", ".jpg")):
                    self.assertIn(name, materials)

    def large_document(self, components: int) -> str:
        leaf = '{"type": "leaf", "length": 0.1}'
        return '{"meristem": 1, "components": {' + ", ".join(f'"c{k}": {leaf}' for k in range(components)) + "}}"

    def test_a_large_text_blocks_no_other_page(self) -> None:
        with self.studio.page() as large, self.studio.page() as other:
            large.ask("open", text=self.large_document(1000), path=None)
            old = large.send("text", text=self.large_document(300_000))
            # A newer text makes that reading useless: its answer says so and does not wait for it.
            newest = large.send("text", text=BUSH)
            self.assertEqual(other.ask("open", path="bush.json")["is"], "done")
            stopped = large.wait(lambda message: message.get("re") == old and message["is"] == "done")
            self.assertTrue(stopped.get("superseded"))
            self.assertNotIn("faults", stopped)
            answer = large.wait(lambda message: message.get("re") == newest and message["is"] == "done")
            self.assertTrue(answer["good"])

    def test_ends_on_ctrl_c_while_it_reads(self) -> None:
        with Studio(PROGRAM, Path(self.folder.name)) as studio:
            page = studio.page()
            page.send("open", text=self.large_document(300_000), path=None)
            studio.process.send_signal(signal.SIGINT)
            self.assertEqual(studio.process.wait(timeout=10), 0)
            page.__exit__()

    def test_ends_on_ctrl_c_in_the_middle_of_work(self) -> None:
        with Studio(PROGRAM, Path(self.folder.name)) as studio:
            page = studio.page()
            page.ask("open", model="chestnut")
            page.send("export", format=".glb")
            self.assertEqual(studio.stop(), 0)
            with self.assertRaises(Closed):
                page.wait(lambda message: False)
            page.__exit__()

    def test_ends_on_ctrl_c_in_the_middle_of_a_film(self) -> None:
        with Studio(PROGRAM, Path(self.folder.name)) as studio:
            page = studio.page()
            page.ask("open", path="bush.json")
            page.send("export", format=".png", options={"frames": {"from": 0, "to": 900, "step": 0.1}})
            page.wait(lambda message: message["is"] == "working" and message["job"] == "export")
            self.assertEqual(studio.stop(), 0)
            page.__exit__()

    def film_studio(self, script: str) -> Studio:
        """A studio whose ffmpeg is a script."""
        maker = Path(self.folder.name) / "bin" / "ffmpeg"
        maker.parent.mkdir(exist_ok=True)
        maker.write_text(f"#!/bin/sh\n{script}\n")
        maker.chmod(0o755)
        return Studio(PROGRAM, Path(self.folder.name), path=f"{maker.parent}:/usr/bin:/bin")

    FILM = {"width": 16, "height": 16, "samples": 1, "frames": {"from": 0, "to": 0.1, "step": 0.1}}

    def test_tells_when_a_film_has_failed(self) -> None:
        with self.film_studio('echo "no such codec" >&2; exit 3') as studio, studio.page() as page:
            page.ask("open", path="bush.json")
            refused = page.ask("export", format=".mp4", options=self.FILM)
            self.assertEqual(refused["is"], "refused")
            self.assertIn("no such codec", refused["message"])

    def test_a_film_is_cancelled_while_it_is_encoded(self) -> None:
        begun = Path(self.folder.name) / "begun"
        with self.film_studio(f"echo $$ >{begun}.new; mv {begun}.new {begun}; exec sleep 600") as studio, studio.page() as page:
            page.ask("open", path="bush.json")
            number = page.send("export", format=".mp4", options=self.FILM)
            while not begun.exists():
                time.sleep(0.02)
            page.send("cancel", re=number)
            refused = page.wait(lambda message: message.get("re") == number and message["is"] != "working")
            self.assertTrue(refused["cancelled"])
            self.assertFalse(Path(f"/proc/{begun.read_text().strip()}").exists(), "the encoder has ended")

    def test_names_the_port_that_is_taken(self) -> None:
        run = subprocess.run([PROGRAM, "studio", "--no-browser", "--port", str(self.studio.port)], capture_output=True, text=True)
        self.assertEqual(run.returncode, 1)
        self.assertIn(str(self.studio.port), run.stderr)

    def test_has_pictures_of_models(self) -> None:
        with self.studio.page() as page:
            models = {model["name"]: model for model in page.ask("models")["models"]}
            self.assertTrue(models["oak"]["picture"])
            response = self.studio.get("pictures/oak.jpg")
            self.assertEqual(response.status, 200)
            self.assertEqual(response.headers["content-type"], "image/jpeg")
            self.assertLess(len(response.body), 20_000)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

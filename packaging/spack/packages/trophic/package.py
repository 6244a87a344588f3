# SPDX-License-Identifier: MIT
# A Spack repository of one package: spack repo add packaging/spack && spack install trophic. `scripts/release` writes the archive's
# address and checksum into a copy.
from spack.package import *


class Trophic(CMakePackage):
    """Ecologies of simulated robots: rules at compile time, physics behind an adapter."""

    homepage = "URL/trophic-0.1.0.tar.gz"
    url = "URL/trophic-0.1.0.tar.gz"

    license("MIT")

    version("0.1.0", sha256="SHA256")

    # Spack's own mujoco is 2.1.0, and it has no Open Dynamics Engine. A newer MuJoCo is an external package of your packages.yaml.
    variant("mujoco", default=False, description="Physics by MuJoCo, the reference engine")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("cmake@3.24:", type="build")
    depends_on("ninja", type="build")
    depends_on("eigen@3.4:5")
    depends_on("random123")
    depends_on("tomlplusplus")
    depends_on("nlohmann-json")
    depends_on("zlib-api")
    depends_on("cli11")
    depends_on("yaml-cpp")
    depends_on("boost@1.74:")
    depends_on("mujoco@2.2:", when="+mujoco")
    depends_on("pugixml", when="+mujoco")
    depends_on("py-jinja2", type="run")
    depends_on("py-matplotlib", type="run")
    depends_on("py-pandas", type="run")
    depends_on("py-scipy", type="run")

    conflicts("%gcc@:11", msg="trophic needs C++20 of g++ 12 or newer")
    conflicts("%clang@:13", msg="trophic needs C++20 of clang 14 or newer")

    generator("ninja")

    def cmake_args(self):
        return [
            self.define("TROPHIC_BUILD_TESTS", False),
            self.define("TROPHIC_WARNINGS_AS_ERRORS", False),
            self.define("TROPHIC_BACKEND_MUJOCO", "ON" if "+mujoco" in self.spec else "OFF"),
            self.define("TROPHIC_BACKEND_ODE", "OFF"),
        ] + ([self.define("mujoco_ROOT", self.spec["mujoco"].prefix)] if "+mujoco" in self.spec else [])

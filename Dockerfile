# The system of README.md with trophic's programs:
#   docker build -t trophic .
#   docker run --rm -v "$PWD/runs:/data/runs" trophic trophic-predator-prey --backend kinematic --out runs/first
FROM debian:12 AS build
COPY . /src
WORKDIR /src
RUN scripts/setup g++ cmake make ninja-build git libboost-dev libeigen3-dev librandom123-dev libtomlplusplus-dev nlohmann-json3-dev zlib1g-dev \
      libcli11-dev libpugixml-dev libmujoco-dev libode-dev libgl-dev \
 && cmake --preset release -DTROPHIC_BACKEND_MUJOCO=ON -DTROPHIC_BACKEND_ODE=ON \
 && cmake --build --preset release \
 && cmake --install build/release --prefix /usr/local

FROM debian:12
RUN apt-get update \
 && apt-get install -y --no-install-recommends libmujoco2.2.2 libode8 libpugixml1v5 libtomlplusplus3 \
 && rm -rf /var/lib/apt/lists/*
COPY --from=build /usr/local /usr/local
WORKDIR /data
CMD ["trophic", "--help"]

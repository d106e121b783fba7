# A static program in an empty image: `docker build -t tankcheck .`, then
# `docker run --rm --user "$(id -u):$(id -g)" -v "$PWD:/work" tankcheck check tank.json`.

# A tag: images of Rust are rebuilt under their tags, and a digest is one build. To pin it: --build-arg RUST=rust@sha256:…
ARG RUST=rust:1-alpine
FROM ${RUST} AS build
RUN apk add --no-cache musl-dev python3
WORKDIR /source
# rust-toolchain.toml asks for components that a build does not need.
ENV RUSTUP_TOOLCHAIN=stable
COPY . .
RUN target=$(rustc -vV | sed -n 's/^host: //p') \
    && cargo build --locked --profile dist --bin tankcheck --target "$target" \
    && install -D -m 755 "target/$target/dist/tankcheck" /image/bin/tankcheck \
    && python3 packaging/licences --target "$target" /image/licences/THIRD-PARTY.txt \
    && install -m 644 LICENSE-MIT LICENSE-APACHE LICENSE-OFL /image/licences/ \
    && install -d -m 1777 /image/tmp /image/work

FROM scratch
COPY --from=build /image/ /
WORKDIR /work
ENTRYPOINT ["/bin/tankcheck"]
CMD ["--help"]

//! API 650, seismic design of storage tanks.

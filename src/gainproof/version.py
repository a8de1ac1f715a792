"""The version of gainproof, in a file of its own: the build reads it without importing."""

VERSION = "0.2.0"

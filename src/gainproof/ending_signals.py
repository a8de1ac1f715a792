"""Signals that end a program; systems lack some. Imports nothing: `start` reads it first."""

SIGNALS = ("SIGINT", "SIGTERM", "SIGHUP")

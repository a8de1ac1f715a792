"""Certificates and error bounds put before tools that share no code with gainproof."""

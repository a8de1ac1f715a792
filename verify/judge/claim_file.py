"""Claim files: TOML read into frozen records, everything checked."""

from __future__ import annotations

from gainproof.verify.judge.claim_record import (
    Claim,
    ClaimFile,
    OwnModel,
    Setting,
    SourceRecord,
    SymbolEntry,
    Unit,
)

__all__ = ["Claim", "ClaimFile", "OwnModel", "Setting", "SourceRecord", "SymbolEntry", "Unit"]

"""What systems of IEC 61131-3 Structured Text have and do, as `stickler data` writes it.

>>> from stickler_data import load
>>> for answer in load()["questions"]["REAL_TO_INT(REAL#2.5) : INT"]:
...     print(answer["answer"], answer["kind"], answer["systems"])
"""

from __future__ import annotations

import json
from functools import lru_cache
from importlib.resources import files
from typing import Any, Dict, List, Optional, TypedDict


class Answer(TypedDict):
    """An answer, and the systems that give it."""

    answer: str
    kind: str
    source: Optional[str]
    systems: List[str]


class SupportData(TypedDict):
    """The whole document; stickler-data.schema.json describes each key."""

    version: str
    systems: Dict[str, Dict[str, Any]]
    features: Dict[str, Dict[str, Any]]
    conversions: Dict[str, List[Dict[str, Any]]]
    functions: Dict[str, Dict[str, Any]]
    questions: Dict[str, List[Answer]]
    sources: Dict[str, Dict[str, str]]


@lru_cache(maxsize=None)
def load() -> SupportData:
    """Returns the data, which is read once."""
    text = files(__name__).joinpath("data.json").read_text(encoding="utf-8")
    data: SupportData = json.loads(text)
    return data

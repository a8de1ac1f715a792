"""Long work cut into numbered, independent blocks: over any executor, resumed where it stopped.

- `Campaign`: a name, a pure function of plain data, its arguments block by block, and a report.
- `run`: over any executor of `concurrent.futures`; `executors.opened` makes one by its name.
- `state`: a file with a line for each block that is done.
- `options`: all of this on a command line.
"""

from gainproof.campaign.campaign import Campaign, Done, Report
from gainproof.campaign.running import run

__all__ = ["Campaign", "Done", "Report", "run"]

"""Long work cut into numbered, independent blocks: over any executor, resumed where it stopped.

- `campaign.Campaign`: a name, a pure function of plain data, its arguments by block, a report.
- `running.run`: over any executor of `concurrent.futures`; `executors.opened` makes one by name.
- `state`: a file with a line for each block that is done.
- `options`, `carrying_out`: all of this on a command line.
- `catalogue`: the campaigns that `gainproof campaign` knows.
"""

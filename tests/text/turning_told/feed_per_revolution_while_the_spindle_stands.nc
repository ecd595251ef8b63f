(run with: --machine lathe2)
O1 (Codes of builders)
G00X50.Z5.
G01X40.F.1 (expect assumed: feed per revolution while no spindle turns)
G01X41.
M30

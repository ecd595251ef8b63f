(run with: --machine lathe2)
O1 (T0100 keeps the tool, T0003 too)
T0101
T0100
T0003
T0202
M30
(finally records: tool 1; tool 2)

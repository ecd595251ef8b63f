(run with: --machine lathe2)
O1 (PS0052: corners of a lathe lie between lines)
G98 G00 X20. Z0.
G01 Z-20. ,R2. F100
G03 X40. Z-30. R10. (expect alarm PS0052)
M30

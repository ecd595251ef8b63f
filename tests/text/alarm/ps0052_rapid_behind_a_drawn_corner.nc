(run with: --machine lathe2)
O1 (PS0052: a rapid is no G01)
G98 G00 X20. Z0.
G01 X30. ,C2. F100
G00 Z-20. (expect alarm PS0052)
M30

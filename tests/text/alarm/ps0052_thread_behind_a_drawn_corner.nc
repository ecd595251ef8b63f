(run with: --machine lathe2)
O1 (PS0052: a thread is no G01)
G98 G00 X20. Z0.
G97 S500 M03
G01 X30. ,C2. F100 (expect alarm PS0052)
G32 Z-20. F1.5
M30

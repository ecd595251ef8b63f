(run with: --machine lathe2)
O1 (PS0057: X, Z and the angle contradict each other)
G98 G00 X20. Z0.
G01 X40. Z-20. ,A150. F100 (expect alarm PS0057 says beside the line)
M30

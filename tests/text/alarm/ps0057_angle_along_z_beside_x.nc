(run with: --machine lathe2)
O1 (PS0057: a line along Z never comes to X40)
G98 G00 X20. Z0.
G01 X40. ,A180. F100 (expect alarm PS0057 at ,A180.)
M30

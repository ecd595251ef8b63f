(run with: --machine lathe2 --set #2901=0.8 --set #2301=3)
O1 (turning, nose radius: R0.5 and a nose of 0.8)
G00 X40. Z5. T0101
G42 G00 X20. Z2.
G01 Z-10. F.1
G02 X21. Z-10.5 R.5 (expect alarm PS0041)
G01 X40.
M30

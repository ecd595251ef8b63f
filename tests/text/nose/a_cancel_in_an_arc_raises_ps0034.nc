(run with: --machine lathe2 --set #2901=0.8 --set #2301=3)
O1 (turning, nose radius: compensation cannot end with an arc)
G00 X40. Z5. T0101
G42 G00 X20. Z2.
G01 Z-10. F.1
G40 G02 X26. Z-13. R3. (expect alarm PS0034)
M30

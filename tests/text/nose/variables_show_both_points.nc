(run with: --machine lathe2 --set #2901=0.8 --set #2301=3)
O1 (turning, nose radius: #5001 is the programmed point, #5041 the tip)
G00 X60. Z5. T0101
G42 G00 X20. Z2.
G01 Z-10. F.1
#100=#5001 (expect #100=20)
#101=#5002 (expect #101=-10)
#102=#5041 (expect #102=20)
#103=#5042 (expect #103=-10.8)
G40 G00 X60.
M30

O1 (NUM-4: F45 is 0.45 inch per minute)
G20
G01 X1. F45 (expect assumed: 0.01)
M30

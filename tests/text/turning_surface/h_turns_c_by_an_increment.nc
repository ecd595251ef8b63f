(run with: --machine lathe3c)
O1 (words of ways)
G00X60.Z2.C90.
G00H-30. (expect moves: rapid C60)
G00X50.H15000 (expect moves: rapid X50 C75)
C370. (expect moves: rapid C370)
G28H0 (expect moves: rapid C0)
M30

(run with: --param G67=1)
O1 (CALL-18: with parameter G67 1)
G67
#100=1 (expect #100=1)
M30

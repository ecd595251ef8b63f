(run with: --machine lathe2 --param gsystem=B)
O1 (U W are increments of system A alone)
G01U1.F.2 (expect alarm PS0009 at U1.)
M30

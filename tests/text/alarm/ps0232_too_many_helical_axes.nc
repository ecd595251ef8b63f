(run with: --machine mill5)
O1 (PS0232: Z, A and C beside an arc in XY)
G03 X10. I5. Z1. A1. C1. F100 (expect alarm PS0232)
M30

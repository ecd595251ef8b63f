(run with: --machine mill5)
O1 (ARC-8: a helix has at most two)
G02 X10. I5. Z1. A1. C1. F100 (expect alarm PS0232)
M30

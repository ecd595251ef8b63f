(run with: --param n_offsets=32)
O1 (section 3.5: with 32 offsets there is no 33)
#100=#10032 (expect #100=0)
#101=#10033 (expect alarm PS0115)
M30

O1 (section 3.3: mill3 has three axes)
#100=#5004 (expect alarm PS0115)
M30

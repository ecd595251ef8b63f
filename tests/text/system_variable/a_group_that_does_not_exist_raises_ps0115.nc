O1 (section 3.2: there is no group 18 on the mill)
#100=#4018 (expect alarm PS0115)
M30

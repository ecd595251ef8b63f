[BILLET X50 Z100 (expect alarm PS0009)

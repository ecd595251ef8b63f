x=(-8)^0.5 ' (expect alarm LB0018 at ^)

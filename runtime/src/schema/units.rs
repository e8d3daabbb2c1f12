//! The units of brackets.

use super::language;

language! {
    /// The units that brackets can hold, joined by `*`, `/` and `^`.
    Units {
        "Gram, with a prefix of SI."
            g pg ng ug mg cg dg dag hg kg Mg Gg Tg;
        "Meter, with a prefix of SI."
            m pm nm um mm cm dm dam hm km Mm Gm Tm;
        "Second, with a prefix of SI."
            s ps ns us ms cs ds das hs ks Ms Gs Ts;
        "Ampere, with a prefix of SI."
            A pA nA uA mA cA dA daA hA kA MA GA TA;
        "Kelvin, with a prefix of SI."
            K pK nK uK mK cK dK daK hK kK MK GK TK;
        "Mole, with a prefix of SI."
            mol pmol nmol umol mmol cmol dmol damol hmol kmol Mmol Gmol Tmol;
        "Candela, with a prefix of SI."
            cd pcd ncd ucd mcd ccd dcd dacd hcd kcd Mcd Gcd Tcd;
        "Radian, with a prefix of SI."
            rad prad nrad urad mrad crad drad darad hrad krad Mrad Grad Trad;
        "Steradian, with a prefix of SI."
            sr psr nsr usr msr csr dsr dasr hsr ksr Msr Gsr Tsr;
        "Hertz, with a prefix of SI."
            Hz pHz nHz uHz mHz cHz dHz daHz hHz kHz MHz GHz THz;
        "Newton, with a prefix of SI."
            N pN nN uN mN cN dN daN hN kN MN GN TN;
        "Pascal, with a prefix of SI."
            Pa pPa nPa uPa mPa cPa dPa daPa hPa kPa MPa GPa TPa;
        "Joule, with a prefix of SI."
            J pJ nJ uJ mJ cJ dJ daJ hJ kJ MJ GJ TJ;
        "Watt, with a prefix of SI."
            W pW nW uW mW cW dW daW hW kW MW GW TW;
        "Coulomb, with a prefix of SI."
            C pC nC uC mC cC dC daC hC kC MC GC TC;
        "Volt, with a prefix of SI."
            V pV nV uV mV cV dV daV hV kV MV GV TV;
        "Tesla, with a prefix of SI."
            T pT nT uT mT cT dT daT hT kT MT GT TT;
        "Weber, with a prefix of SI."
            Wb pWb nWb uWb mWb cWb dWb daWb hWb kWb MWb GWb TWb;
        "60 s." min;
        "3600 s." h;
        "86400 s." day;
        "1000 kg." t;
        "0.001 m³." L;
        "100000 Pa." bar;
        "0.0254 m." inch;
        "0.3048 m." ft;
        "0.9144 m." yd;
        "1609.344 m." mi;
        "1852 m." nmi;
        "1852 m/h." knot;
        "0.45359237 kg." lb;
        "lb / 16." oz;
        "4.4482216152605 N." lbf;
        "9.80665 N." kgf;
        "lbf s²/ft." slug;
        "1/360 of a turn." deg;
        "1/60 deg." arcmin;
        "1/3600 deg." arcsec;
        "A turn, 2 π rad." rev;
        "Turns per minute." rpm;
    }
}
